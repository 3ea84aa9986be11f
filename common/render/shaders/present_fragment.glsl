// The frame as straight sRGB, samples and background mixed in blend space.
layout(location = 0) out vec4 outColour;

#ifdef SAMPLES
layout(binding = 1) uniform sampler2DMS frame;
#else
layout(binding = 1) uniform sampler2D frame;
#endif
uniform vec4 background; // premultiplied, in blend space
uniform ivec2 corner;    // of the target's part of the frame
uniform bool isPremultiplied;

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy) - corner;
    vec4 sum = vec4(0.0);
#ifdef SAMPLES
    for (int i = 0; i < SAMPLES; ++i) {
        vec4 one = texelFetch(frame, at, i);
        sum += isPremultiplied ? one : vec4(one.rgb * one.a, one.a);
    }
    sum /= float(SAMPLES);
#else
    sum = texelFetch(frame, at, 0);
    if (!isPremultiplied)
        sum.rgb *= sum.a;
#endif
    sum += (1.0 - sum.a) * background;
    vec3 straight = sum.a > 0.0 ? clamp(sum.rgb / sum.a, 0.0, 1.0) : vec3(0.0);
#ifdef LINEAR_BLENDING
    straight = encoded(straight);
#endif
    outColour = vec4(straight, sum.a);
}
