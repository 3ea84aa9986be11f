// What the substrate pass left at this place of the frame.
#ifdef SAMPLES
#define FRAME_SAMPLER(prefix) prefix##sampler2DMS
#define FRAME_TEXEL(texture) texelFetch(texture, ivec2(gl_FragCoord.xy), gl_SampleID)
#else
#define FRAME_SAMPLER(prefix) prefix##sampler2D
#define FRAME_TEXEL(texture) texelFetch(texture, ivec2(gl_FragCoord.xy), 0)
#endif

layout(binding = 0) uniform FRAME_SAMPLER(u) surfaces; // stack (0: nothing), depth

uniform uint onlyStack; // 0: any

bool isColoured(uvec2 found)
{
    return found.x != 0u && (onlyStack == 0u || found.x == onlyStack);
}
