// Elements that lie before what is drawn now at this place: each shows its first skin only.
#ifdef SAMPLES
layout(binding = 4) uniform usampler2DMSArray peeled;
#else
layout(binding = 4) uniform usampler2DArray peeled;
#endif
uniform int peelCount;

bool isPeeled(uint element)
{
    for (int i = 0; i < peelCount; ++i) {
#ifdef SAMPLES
        uint before = texelFetch(peeled, ivec3(ivec2(gl_FragCoord.xy), i), gl_SampleID).x;
#else
        uint before = texelFetch(peeled, ivec3(ivec2(gl_FragCoord.xy), i), 0).x;
#endif
        // Nothing before means nothing behind.
        if (before == element || before == 0u)
            return true;
    }
    return false;
}
