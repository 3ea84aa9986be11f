// A layer's own colour onto the frame.
layout(location = 0) out vec4 outColour;

layout(binding = 1) uniform FRAME_SAMPLER() layerColours; // premultiplied
#ifdef READS_FRAME
layout(binding = 2) uniform FRAME_SAMPLER() backdrops; // the frame itself
#endif
#ifdef MASK_TEXTURE
layout(binding = 3) uniform FRAME_SAMPLER() maskProduct;
#endif

uniform float opacity;

void main()
{
    vec4 source = FRAME_TEXEL(layerColours);
    if (source.a <= 0.0)
        discard;
    float share = opacity;
#ifdef MASK_TEXTURE
    share *= FRAME_TEXEL(maskProduct).r;
#endif
#ifdef READS_FRAME
    vec4 backdrop = FRAME_TEXEL(backdrops);
    float a = source.a * share;
    vec3 straight = clamp(source.rgb / source.a, 0.0, 1.0);
    outColour = vec4((1.0 - a) * backdrop.rgb + a * blended(backdrop.rgb, straight), backdrop.a);
#else
    outColour = source * share; // the fixed blending does the rest
#endif
}
