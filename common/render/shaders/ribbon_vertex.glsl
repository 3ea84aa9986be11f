// A stroke's centreline as a strip that faces the eye (upload/ribbon_vertex.h).
layout(location = 0) in vec4 inPosition; // element's space; w: half width, < 0 on the other side
layout(location = 1) in vec4 inAlong;    // w: section
layout(location = 2) in vec4 inNormal;
layout(location = 3) in vec4 inColour;   // sRGB, opacity
layout(location = 4) in uint inElement;
layout(location = 5) in float inWidening;

out vec4 vPlace; // depth, half width, -1 to 1 across the ribbon, how far it bulges
out vec4 vColour;
flat out uvec4 sElement; // id, order, stack

uniform vec4 ribbonColour; // in blend space; w = 1: goes before the stroke's own

const float ellipseThickness = 0.3;

void main()
{
    ElementData e = elements[inElement];
    vec3 at = relativeToEye(e, inPosition.xyz);
    vec3 along = turned(e, inAlong.xyz), normal = turned(e, inNormal.xyz);
    int section = int(inAlong.w * 32767.0 + 0.5);
    float halfWidth = abs(inPosition.w) * e.scale * inWidening, side = sign(inPosition.w);

    vec3 facing = cross(along, at);
    float facingLength = length(facing);
    facing = facingLength > 1e-3 * length(at) ? facing / facingLength : normal;
    vec3 across = normalize(cross(normal, along)), out_ = facing * halfWidth;
    if (section == 3) // ribbons lie as they lie
        out_ = across * halfWidth;
    else if (section == 2)
        out_ *= abs(dot(facing, across)) + abs(dot(facing, normal));
    else if (section == 1)
        out_ *= length(vec2(dot(facing, across), ellipseThickness * dot(facing, normal)));
    at += side * out_;

    vPlace = vec4(dot(at, view.forward.xyz), halfWidth, side, section == 0 ? 1.0 : section == 3 ? 0.0 : 0.3);
#ifdef LINEAR_BLENDING
    vec3 own = mix(pow((inColour.rgb + 0.055) / 1.055, vec3(2.4)), inColour.rgb / 12.92,
                   lessThanEqual(inColour.rgb, vec3(0.04045)));
#else
    vec3 own = inColour.rgb;
#endif
    vColour = vec4(ribbonColour.w > 0.5 ? ribbonColour.rgb : own, inColour.a);
    sElement = uvec4(e.elementId, e.order, e.stackId, 0u);
    gl_Position = view.clipFromRelative * vec4(at, 1.0);
}
