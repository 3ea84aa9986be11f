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
    outColour = colourAt(parameter(s * direction));
    outColour.a *= layerOpacity;
    outSurface = uvec2(sElement.z, floatBitsToUint(s));
    outElement = sElement.x;
    // Not by discard, with which software renderers blend every pixel of a box all the same: 0 is never GL_GREATER.
    gl_FragDepth = s < far && outColour.a > 0.0 ? depthValue(s) : 0.0;
}
