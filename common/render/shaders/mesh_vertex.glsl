layout(location = 0) in vec3 inPosition; // element's space
layout(location = 1) in vec4 inColour;   // linear
layout(location = 2) in uint inElement;

out vec3 vRelative; // to the eye
out vec3 vColour;
flat out uvec4 sElement; // id, order, stack

void main()
{
    ElementData e = elements[inElement];
    vRelative = relativeToEye(e, inPosition);
    vColour = inColour.rgb;
    sElement = uvec4(e.elementId, e.order, e.stackId, 0u);
    gl_Position = view.clipFromRelative * vec4(vRelative, 1.0);
}
