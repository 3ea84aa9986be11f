// Colours what is near a triangle of a mesh.
flat in vec3 sA;
flat in vec3 sB;
flat in vec3 sC;
flat in uint sOrder;

layout(location = 0) out vec4 outColour;

uniform float tolerance;
uniform vec4 colour; // blend space

float squared(vec3 v)
{
    return dot(v, v);
}

float distance2ToEdge(vec3 p, vec3 a, vec3 b)
{
    vec3 ab = b - a;
    float t = clamp(dot(p - a, ab) / max(dot(ab, ab), 1e-30), 0.0, 1.0);
    return squared(p - a - t * ab);
}

bool isNear(vec3 p, vec3 direction)
{
    vec3 e1 = sB - sA, e2 = sC - sA, normal = cross(e1, e2);
    float area = dot(normal, normal);
    if (area == 0.0)
        return false;
#ifdef VIEW_TOLERANCE
    // [Moeller, Trumbore 1997]
    vec3 k = cross(direction, e2);
    float det = dot(e1, k);
    vec3 from = p - sA;
    float u = dot(from, k) / det;
    vec3 other = cross(from, e1);
    float v = dot(direction, other) / det;
    return det != 0.0 && u >= -1e-6 && v >= -1e-6 && u + v <= 1.000001 && abs(dot(e2, other) / det) <= tolerance;
#else
    vec3 from = p - sA;
    float height = dot(from, normal);
    float w2 = dot(cross(e1, from), normal), w1 = dot(cross(from, e2), normal);
    bool isAbove = w1 >= 0.0 && w2 >= 0.0 && w1 + w2 <= area;
    float d2 = isAbove ? height * height / area
                       : min(distance2ToEdge(p, sA, sB), min(distance2ToEdge(p, sB, sC), distance2ToEdge(p, sC, sA)));
    return d2 <= tolerance * tolerance;
#endif
}

void main()
{
    uvec2 found = FRAME_TEXEL(surfaces).xy;
    if (!isColoured(found))
        discard;
    vec3 direction = rayThrough(FRAGMENT_PLACE);
    if (!isNear(uintBitsToFloat(found.y) * direction, direction))
        discard;
#ifdef COVERAGE_ONLY
    outColour = vec4(1.0);
#else
    outColour = colour;
    gl_FragDepth = orderDepth(sOrder);
#endif
}
