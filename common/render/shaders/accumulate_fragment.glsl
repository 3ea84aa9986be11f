// One more surface behind those that are there: the fixed blending weighs it by what they let through.
layout(location = 0) out vec4 outColour;

layout(binding = 1) uniform FRAME_SAMPLER() layerColours;

void main()
{
    vec4 colour = FRAME_TEXEL(layerColours);
    outColour = vec4(colour.rgb * colour.a, colour.a);
}
