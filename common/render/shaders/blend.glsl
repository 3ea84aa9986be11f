// W3C Compositing and Blending Level 1, as painting/blend/blend.cpp. b: backdrop, s: source, straight.
float hardLight(float b, float s)
{
    return s <= 0.5 ? 2.0 * b * s : b + (2.0 * s - 1.0) - b * (2.0 * s - 1.0);
}

float colourDodge(float b, float s)
{
    return b <= 0.0 ? 0.0 : s >= 1.0 ? 1.0 : min(1.0, b / (1.0 - s));
}

float colourBurn(float b, float s)
{
    return b >= 1.0 ? 1.0 : s <= 0.0 ? 0.0 : 1.0 - min(1.0, (1.0 - b) / s);
}

float softLight(float b, float s)
{
    float d = b <= 0.25 ? ((16.0 * b - 12.0) * b + 4.0) * b : sqrt(b);
    return s <= 0.5 ? b - (1.0 - 2.0 * s) * b * (1.0 - b) : b + (2.0 * s - 1.0) * (d - b);
}

float lum(vec3 c)
{
    return dot(c, vec3(0.3, 0.59, 0.11));
}

float lowest(vec3 c)
{
    return min(c.r, min(c.g, c.b));
}

float highest(vec3 c)
{
    return max(c.r, max(c.g, c.b));
}

vec3 setLum(vec3 c, float l)
{
    c += l - lum(c);
    float l2 = lum(c), n = lowest(c), x = highest(c);
    if (n < 0.0)
        c = l2 + (c - l2) * (l2 / (l2 - n));
    if (x > 1.0)
        c = l2 + (c - l2) * ((1.0 - l2) / (x - l2));
    return clamp(c, 0.0, 1.0);
}

vec3 setSat(vec3 c, float s)
{
    float range = highest(c) - lowest(c);
    return range <= 0.0 ? vec3(0.0) : (c - lowest(c)) * (s / range);
}

#define EACH(function) vec3(function(b.r, s.r), function(b.g, s.g), function(b.b, s.b))

// BLEND_MODE is the place in the enum BlendMode.
vec3 blended(vec3 b, vec3 s)
{
#if BLEND_MODE == 0
    return s;
#elif BLEND_MODE == 1
    return b * s;
#elif BLEND_MODE == 2
    return b + s - b * s;
#elif BLEND_MODE == 3
    return vec3(hardLight(s.r, b.r), hardLight(s.g, b.g), hardLight(s.b, b.b));
#elif BLEND_MODE == 4
    return min(vec3(1.0), b + s);
#elif BLEND_MODE == 5
    return min(b, s);
#elif BLEND_MODE == 6
    return max(b, s);
#elif BLEND_MODE == 7
    return EACH(colourDodge);
#elif BLEND_MODE == 8
    return EACH(colourBurn);
#elif BLEND_MODE == 9
    return EACH(hardLight);
#elif BLEND_MODE == 10
    return EACH(softLight);
#elif BLEND_MODE == 11
    return abs(b - s);
#elif BLEND_MODE == 12
    return b + s - 2.0 * b * s;
#elif BLEND_MODE == 13
    return setLum(setSat(s, highest(b) - lowest(b)), lum(b));
#elif BLEND_MODE == 14
    return setLum(setSat(b, highest(s) - lowest(s)), lum(b));
#elif BLEND_MODE == 15
    return setLum(s, lum(b));
#elif BLEND_MODE == 16
    return setLum(b, lum(s));
#endif
}
