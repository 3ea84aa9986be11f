// Strokes that colour what lies inside them or within their tolerance.
layout(location = 0) out vec4 outColour; // premultiplied, in blend space; 1 for masks

uniform float tolerance;
uniform float share;    // of the strokes' opacity
uniform uint orderStep; // 0: all strokes of the layer are one

#ifdef SURFACE_TOLERANCE
vec3 reachAt(vec3 x)
{
    vec3 reach = mix(sReachA, sReachB, parameter(x));
    float l = length(reach);
    return l > 0.0 ? reach / l : vec3(0.0);
}
#endif

bool covers(vec3 x, vec3 direction)
{
#if defined(VIEW_TOLERANCE)
    vec2 along = interval(x, direction);
    return along.x <= tolerance && along.y >= -tolerance && along.x <= along.y;
#elif defined(SURFACE_TOLERANCE)
    vec3 reach = reachAt(x);
    if (reach == vec3(0.0))
        return contains(x);
    vec2 along = interval(x, reach);
    return along.x <= tolerance && along.y >= -tolerance && along.x <= along.y;
#else
    return contains(x);
#endif
}

void main()
{
    uvec2 found = FRAME_TEXEL(surfaces).xy;
    vec3 direction = rayThrough(FRAGMENT_PLACE);
    vec3 x = uintBitsToFloat(found.y) * direction;
    bool isCovered = isColoured(found) && covers(x, direction);
#ifdef COVERAGE_ONLY
    if (!isCovered)
        discard;
    outColour = vec4(1.0);
#else
    vec4 colour = colourAt(parameter(x));
    colour.a *= share;
    outColour = vec4(colour.rgb * colour.a, colour.a);
    // Not by discard, with which software renderers blend every pixel of a box all the same: 1 is never GL_LESS.
    gl_FragDepth = isCovered ? orderDepth(sElement.y * orderStep) : 1.0;
#endif
}
