// One mask's share at every surface point a layer colours; passes multiply. painting/coverage/mask_value.h
layout(location = 0) out float outShare;

layout(binding = 1) uniform FRAME_SAMPLER() layerColours;
uniform bool inverted;

#if MASK_KIND == 0 || MASK_KIND == 1 // gradient: linear, spherical
uniform vec3 start; // relative to the eye
uniform vec3 axis;
uniform vec2 opacities; // at start, at end
uniform bool smoothEasing;

float valueAt(vec3 x)
{
    vec3 from = x - start;
#if MASK_KIND == 0
    float t = dot(from, axis) / dot(axis, axis);
#else
    float t = length(from) / length(axis);
#endif
    t = clamp(t, 0.0, 1.0);
    if (smoothEasing)
        t = t * t * (3.0 - 2.0 * t);
    return mix(opacities.x, opacities.y, t);
}
#elif MASK_KIND == 2 // noise
uniform float cellsPerUnit;
uniform ivec3 eyeCell; // the lattice's cell the eye is in, and where in it
uniform vec3 eyeInCell;
uniform uint seedStart;
uniform vec4 ramp; // threshold, softness, low, high

uint mixed(uint h)
{
    h ^= h >> 16;
    h *= 0x7feb352du;
    h ^= h >> 15;
    h *= 0x846ca68bu;
    return h ^ (h >> 16);
}

// What the lattice point gives at a place d away from it.
float latticeValue(ivec3 at, vec3 d)
{
    uint h = mixed(seedStart ^ uint(at.x) * 0x85ebca6bu);
    h = mixed(h ^ uint(at.y) * 0xc2b2ae35u);
    h = mixed(h ^ uint(at.z) * 0x27d4eb2fu);
    uint gradient = h >> 28;
    if (gradient >= 12u)
        return gradient == 12u ? d.x + d.y : gradient == 13u ? d.y - d.x : gradient == 14u ? d.z - d.y : -d.y - d.z;
    float first = gradient < 8u ? d.x : d.y, second = gradient < 4u ? d.y : d.z;
    return ((gradient & 1u) != 0u ? -first : first) + ((gradient & 2u) != 0u ? -second : second);
}

float row(ivec3 at, vec3 d, float w)
{
    return mix(latticeValue(at, d), latticeValue(at + ivec3(1, 0, 0), d - vec3(1.0, 0.0, 0.0)), w);
}

float rows(ivec3 at, vec3 d, vec2 w)
{
    return mix(row(at, d, w.x), row(at + ivec3(0, 1, 0), d - vec3(0.0, 1.0, 0.0), w.x), w.y);
}

float valueAt(vec3 x)
{
    vec3 p = x * cellsPerUnit + eyeInCell;
    vec3 base = floor(p), f = p - base, w = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    ivec3 at = eyeCell + ivec3(base);
    float n = mix(rows(at, f, w.xy), rows(at + ivec3(0, 0, 1), f - vec3(0.0, 0.0, 1.0), w.xy), w.z);
    n = clamp(0.5 + 0.6 * n, 0.0, 1.0);
    float t = ramp.y > 0.0 ? clamp((n - ramp.x) / ramp.y + 0.5, 0.0, 1.0) : float(n >= ramp.x);
    return mix(ramp.z, ramp.w, t);
}
#elif MASK_KIND == 3 // block of values; the card's own filter would round its weights to 8 bits
layout(binding = 3) uniform sampler3D block;
uniform mat4 cubeFromRelative;

float valueAt(vec3 x)
{
    ivec3 size = textureSize(block, 0);
    vec3 cell = clamp((cubeFromRelative * vec4(x, 1.0)).xyz * vec3(size) - 0.5, vec3(0.0), vec3(size - 1));
    ivec3 low = ivec3(cell), high = min(low + 1, size - 1);
    vec3 t = cell - vec3(low);
    float v00 = mix(texelFetch(block, low, 0).r, texelFetch(block, ivec3(high.x, low.yz), 0).r, t.x);
    float v10 = mix(texelFetch(block, ivec3(low.x, high.y, low.z), 0).r,
                    texelFetch(block, ivec3(high.xy, low.z), 0).r, t.x);
    float v01 = mix(texelFetch(block, ivec3(low.xy, high.z), 0).r,
                    texelFetch(block, ivec3(high.x, low.y, high.z), 0).r, t.x);
    float v11 = mix(texelFetch(block, ivec3(low.x, high.yz), 0).r, texelFetch(block, high, 0).r, t.x);
    return mix(mix(v00, v10, t.y), mix(v01, v11, t.y), t.z);
}
#else // where the strokes of another layer are
layout(binding = 3) uniform FRAME_SAMPLER() coverage;
uniform bool inside;

float valueAt(vec3 x)
{
    return (FRAME_TEXEL(coverage).r > 0.5) == inside ? 1.0 : 0.0;
}
#endif

void main()
{
    if (FRAME_TEXEL(layerColours).a <= 0.0)
        discard;
    float depth = uintBitsToFloat(FRAME_TEXEL(surfaces).y);
    float value = valueAt(depth * rayThrough(FRAGMENT_PLACE));
    outShare = inverted ? 1.0 - value : value;
}
