// Ribbons that stand for strokes that are a shape; round ones bulge towards the eye as the stroke would.
in vec4 vPlace;
in vec4 vColour;
flat in uvec4 sElement;

layout(location = 0) out vec4 outColour; // straight, in blend space; a: opacity
layout(location = 1) out uvec2 outSurface; // stack, depth
layout(location = 2) out uint outElement;

uniform float layerOpacity;

void main()
{
#ifdef PEELING
    if (isPeeled(sElement.x))
        discard;
#endif
    float depth = vPlace.x - vPlace.w * vPlace.y * sqrt(max(1.0 - vPlace.z * vPlace.z, 0.0));
    float opacity = vColour.a * layerOpacity;
    if (depth < view.limits.x || opacity <= 0.0)
        discard;
    outColour = vec4(vColour.rgb, opacity);
    outSurface = uvec2(sElement.z, floatBitsToUint(depth));
    outElement = sElement.x;
    gl_FragDepth = depthValue(depth);
}
