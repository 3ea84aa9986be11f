// Triangles that are a shape, from both sides.
in vec3 vRelative;
in vec3 vColour;
flat in uvec4 sElement;

layout(location = 0) out vec4 outColour;
layout(location = 1) out uvec2 outSurface;
layout(location = 2) out uint outElement;

uniform float layerOpacity;
uniform vec4 layerColour;

void main()
{
#ifdef PEELING
    if (isPeeled(sElement.x))
        discard;
#endif
    float depth = dot(vRelative, view.forward.xyz);
    if (depth < view.limits.x)
        discard;
    outColour = vec4(toBlendSpace(layerColour.w > 0.5 ? layerColour.rgb : vColour), layerOpacity);
    outSurface = uvec2(sElement.z, floatBitsToUint(depth));
    outElement = sElement.x;
    gl_FragDepth = depthValue(depth);
}
