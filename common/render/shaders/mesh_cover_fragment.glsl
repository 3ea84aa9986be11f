// Colours what a mesh winds around.
layout(location = 0) out vec4 outColour;

layout(binding = 1) uniform FRAME_SAMPLER() winding;
uniform vec4 colour; // blend space
uniform uint order;

void main()
{
    if (abs(FRAME_TEXEL(winding).r) < 0.5)
        discard;
#ifdef COVERAGE_ONLY
    outColour = vec4(1.0);
#else
    outColour = colour;
    gl_FragDepth = orderDepth(order);
#endif
}
