// The first skin along the ray of strokes that are a shape.
layout(location = 0) out vec4 outColour; // premultiplied by 1: straight, in blend space; a: opacity
layout(location = 1) out uvec2 outSurface; // stack, depth
layout(location = 2) out uint outElement;

uniform float layerOpacity;

void main()
{
#ifdef PEELING
    if (isPeeled(sElement.x))
        discard;
#endif
    vec3 direction = rayThrough(FRAGMENT_PLACE);
    float s = surface(vec3(0.0), direction, view.limits.x);
    if (s >= far)
        discard;
    outColour = colourAt(parameter(s * direction));
    outColour.a *= layerOpacity;
    if (outColour.a <= 0.0)
        discard;
    outSurface = uvec2(sElement.z, floatBitsToUint(s));
    outElement = sElement.x;
    gl_FragDepth = depthValue(s);
}
