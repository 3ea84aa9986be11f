// Where a segment is, line by line as painting/coverage/section.cpp in single precision.
flat in vec4 sA;
flat in vec4 sB;
flat in vec4 sU;
flat in vec4 sV;
flat in vec3 sClipA;
flat in vec3 sClipB;
flat in vec4 sColourA;
flat in vec4 sColourB;
flat in uvec4 sElement;
#ifdef SURFACE_TOLERANCE
flat in vec3 sReachA;
flat in vec3 sReachB;
#endif

const float far = 3.0e38;
const float seamSlack = 1e-3;
const float ellipseThickness = 0.3;
const int sectionRound = 0, sectionEllipse = 1, sectionCube = 2, sectionRibbon = 3;

// A program for one kind of section leaves the others out.
#ifdef ONLY_SECTION
#define SECTION ONLY_SECTION
#else
#define SECTION int(sU.w)
#endif

float slack()
{
    return seamSlack * max(sA.w, sB.w);
}

bool keepsA(vec3 x)
{
    return dot(x - sA.xyz, sClipA) >= -slack();
}

bool keepsB(vec3 x)
{
    return dot(x - sB.xyz, sClipB) <= slack();
}

vec2 both(vec2 one, vec2 other)
{
    return vec2(max(one.x, other.x), min(one.y, other.y));
}

// Where c + s * slope >= 0.
vec2 halfSpace(float c, float slope)
{
    float s = -c / slope;
    return slope > 0.0 ? vec2(s, far) : slope < 0.0 ? vec2(-far, s) : c >= 0.0 ? vec2(-far, far) : vec2(far, -far);
}

// The roots of qa s^2 + 2 qb s + qc in order; far, -far if there are none.
vec2 roots(float qa, float qb, float qc)
{
    float discriminant = qb * qb - qa * qc;
    float root = sqrt(max(discriminant, 0.0));
    float q = -(qb + (qb < 0.0 ? -root : root));
    float s0 = q == 0.0 ? 0.0 : qc / q;
    float s1 = q == 0.0 ? 0.0 : qa == 0.0 ? (q < 0.0 ? -far : far) : q / qa;
    return discriminant < 0.0 ? vec2(far, -far) : vec2(min(s0, s1), max(s0, s1));
}

// The mantle of round segments: cosine2 |p|^2 - y^2 + 2 ra sine y - ra^2 = 0 for isBetween(y), y along the axis.
#define roundAxis sU.xyz
#define roundLength sV.x
#define sine sV.y
#define cosine2 sV.z

bool isBetween(float y)
{
    return y >= sA.w * sine && y <= roundLength + sB.w * sine;
}

bool roundContains(vec3 x)
{
    vec3 p = x - sA.xyz, q = x - sB.xyz;
    float pp = dot(p, p), y = dot(p, roundAxis), toMantle = sA.w - y * sine;
    return pp <= sA.w * sA.w || dot(q, q) <= sB.w * sB.w ||
           (cosine2 > 0.0 && isBetween(y) && cosine2 * (pp - y * y) <= toMantle * toMantle);
}

// A line from its point nearest to the middle of a segment, so that cancellation loses no more than digits of its size:
// at is that point from the segment's middle, square to the direction.
struct Line
{
    float shift; // of that point along the line
    vec3 at;
    vec3 direction;
    float dd, inverse; // squared length of the direction
};

Line lineNear(vec3 origin, vec3 direction)
{
    float dd = dot(direction, direction), inverse = 1.0 / dd;
    vec3 toMiddle = 0.5 * (sA.xyz + sB.xyz) - origin;
    float shift = dot(toMiddle, direction) * inverse;
    return Line(shift, shift * direction - toMiddle, direction, dd, inverse);
}

// Without its shift.
vec2 roundHits(Line line)
{
    float halfLength = 0.5 * roundLength, a = dot(line.at, roundAxis), slope = dot(line.direction, roundAxis);
    float middle = dot(line.at, line.at) + halfLength * halfLength, turn = 2.0 * halfLength * a, pd = halfLength * slope, y = a + halfLength;
    float discriminantA = pd * pd - line.dd * (middle + turn - sA.w * sA.w);
    float discriminantB = pd * pd - line.dd * (middle - turn - sB.w * sB.w);
    float rootA = sqrt(max(discriminantA, 0.0)), rootB = sqrt(max(discriminantB, 0.0));
    vec2 hits = discriminantA < 0.0 ? vec2(far, -far) : vec2(-pd - rootA, rootA - pd) * line.inverse;
    if (discriminantB >= 0.0)
        hits = vec2(min(hits.x, (pd - rootB) * line.inverse), max(hits.y, (pd + rootB) * line.inverse));
    vec2 side = roots(cosine2 * line.dd - slope * slope, cosine2 * pd + (sA.w * sine - y) * slope,
                      cosine2 * (middle + turn) - y * y + 2.0 * sA.w * sine * y - sA.w * sA.w);
    bool any = cosine2 > 0.0 && side.x <= side.y;
    if (any && abs(side.x) < far && isBetween(y + side.x * slope))
        hits = vec2(min(hits.x, side.x), max(hits.y, side.x));
    if (any && abs(side.y) < far && isBetween(y + side.y * slope))
        hits = vec2(min(hits.x, side.y), max(hits.y, side.y));
    return hits;
}

vec2 roundInterval(vec3 origin, vec3 direction)
{
    Line line = lineNear(origin, direction);
    return roundHits(line) + line.shift;
}

// surface() of round segments, which have no caps but their balls.
float roundSurface(vec3 origin, vec3 direction, float from)
{
    Line line = lineNear(origin, direction);
    vec2 hits = roundHits(line);
    vec3 halfAxis = 0.5 * (sB.xyz - sA.xyz);
    vec2 behindA = vec2(dot(line.at + halfAxis, sClipA) + slack(), dot(direction, sClipA));
    vec2 beforeB = vec2(slack() - dot(line.at - halfAxis, sClipB), -dot(direction, sClipB));
    vec2 room = min(behindA.x + hits * behindA.y, beforeB.x + hits * beforeB.y);
    from -= line.shift;
    bool enters = hits.x >= from && hits.x > -far && room.x >= 0.0;
    bool leaves = hits.y >= from && hits.y < far && room.y >= 0.0;
    return enters ? hits.x + line.shift : leaves ? hits.y + line.shift : far;
}

// x: (tau, u, v / thickness)
mat3 flatRows(out float thickness)
{
    vec3 axis = sB.xyz - sA.xyz, u = sU.xyz, v = sV.xyz;
    thickness = SECTION == sectionEllipse ? ellipseThickness : 1.0;
    float det = dot(axis, cross(u, v));
    return mat3(cross(u, v) / det, cross(v, axis) / det, cross(axis, u) / (det * thickness));
}

bool flatContains(vec3 x)
{
    float thickness;
    vec3 p = (x - sA.xyz) * flatRows(thickness);
    float r = min(sA.w + p.x * (sB.w - sA.w), max(sA.w, sB.w));
    return SECTION == sectionCube ? max(abs(p.y), abs(p.z)) <= r : r >= 0.0 && p.y * p.y + p.z * p.z <= r * r;
}

vec2 pyramid(vec3 p, vec3 d, float growth, float widest)
{
    vec2 hits = vec2(-far, far);
    for (int i = 1; i <= 2; ++i)
        for (float side = -1.0; side < 1.5; side += 2.0) {
            hits = both(hits, halfSpace(sA.w + p.x * growth + side * p[i], d.x * growth + side * d[i]));
            hits = both(hits, halfSpace(widest + side * p[i], side * d[i]));
        }
    return hits;
}

vec2 ellipticCone(vec3 p, vec3 d, float growth, float widest)
{
    float dd = dot(d.yz, d.yz), qc = dot(p.yz, p.yz) - widest * widest;
    vec2 cylinder = dd == 0.0 ? (qc <= 0.0 ? vec2(-far, far) : vec2(far, -far)) : roots(dd, dot(p.yz, d.yz), qc);
    if (growth == 0.0)
        return cylinder;
    float r = sA.w + p.x * growth, slope = d.x * growth, qa = dd - slope * slope;
    vec2 hits = roots(qa, dot(p.yz, d.yz) - r * slope, dot(p.yz, p.yz) - r * r);
    if (hits.x > hits.y)
        return hits;
    if (qa > 0.0)
        hits = r + 0.5 * (hits.x + hits.y) * slope >= 0.0 ? hits : vec2(far, -far);
    else
        hits = slope > 0.0 ? vec2(hits.y, far) : slope < 0.0 ? vec2(-far, hits.x) : vec2(far, -far);
    return both(hits, cylinder);
}

vec2 flatInterval(vec3 origin, vec3 direction)
{
    float thickness;
    mat3 rows = flatRows(thickness);
    float shift = dot(0.5 * (sA.xyz + sB.xyz) - origin, direction) / dot(direction, direction);
    vec3 p = (origin + shift * direction - sA.xyz) * rows, d = direction * rows;
    float growth = sB.w - sA.w, widest = max(sA.w, sB.w);
    vec2 hits = SECTION == sectionCube ? pyramid(p, d, growth, widest) : ellipticCone(p, d, growth, widest);
    return hits + shift;
}

// [Moeller, Trumbore 1997]; far if missed.
float hitTriangle(vec3 t0, vec3 t1, vec3 t2, vec3 origin, vec3 direction)
{
    vec3 e1 = t1 - t0, e2 = t2 - t0, k = cross(direction, e2);
    float det = dot(e1, k);
    vec3 from = origin - t0;
    float u = dot(from, k) / det;
    vec3 other = cross(from, e1);
    float v = dot(direction, other) / det;
    const float edge = -1e-6;
    bool hit = det != 0.0 && u >= edge && v >= edge && u + v <= 1.0 - edge;
    return hit ? dot(e2, other) / det : far;
}

float hitRibbon(vec3 origin, vec3 direction)
{
    vec3 a = sA.xyz, b = sB.xyz, u = sA.w * sU.xyz, v = sB.w * sV.xyz;
    float s = hitTriangle(a - u, a + u, b + v, origin, direction);
    return s < far ? s : hitTriangle(a - u, b + v, b - v, origin, direction);
}

vec2 bodyInterval(vec3 origin, vec3 direction)
{
    if (SECTION == sectionRound)
        return roundInterval(origin, direction);
    return flatInterval(origin, direction);
}

bool contains(vec3 x)
{
    if (SECTION == sectionRibbon)
        return false;
    bool inBody;
    if (SECTION == sectionRound)
        inBody = roundContains(x);
    else
        inBody = flatContains(x);
    return inBody && keepsA(x) && keepsB(x);
}

// Where a line is in the solid; x > y if nowhere.
vec2 interval(vec3 origin, vec3 direction)
{
    if (SECTION == sectionRibbon) {
        float s = hitRibbon(origin, direction);
        return s < far ? vec2(s) : vec2(far, -far);
    }
    vec2 clip = both(halfSpace(dot(origin - sA.xyz, sClipA) + slack(), dot(direction, sClipA)),
                     halfSpace(slack() - dot(origin - sB.xyz, sClipB), -dot(direction, sClipB)));
    return both(bodyInterval(origin, direction), clip);
}

void offerCap(vec3 through, vec3 normal, bool atA, vec3 origin, vec3 direction, vec2 body, float from,
              inout float nearest)
{
    float s = dot(through - origin, normal) / dot(direction, normal);
    vec3 x = origin + s * direction;
    if (s >= body.x && s <= body.y && s >= from && (atA ? keepsB(x) : keepsA(x)))
        nearest = min(nearest, s);
}

// The smallest s >= from where a line crosses the skin; far if nowhere.
float surface(vec3 origin, vec3 direction, float from)
{
    if (SECTION == sectionRibbon) {
        float s = hitRibbon(origin, direction);
        return s >= from ? s : far;
    }
    if (SECTION == sectionRound)
        return roundSurface(origin, direction, from);
    vec2 body = bodyInterval(origin, direction);
    float nearest = far;
    if (body.x > body.y)
        return far;
    vec3 x0 = origin + body.x * direction, x1 = origin + body.y * direction;
    if (body.x >= from && body.x > -far && keepsA(x0) && keepsB(x0))
        nearest = body.x;
    if (body.y >= from && body.y < nearest && keepsA(x1) && keepsB(x1))
        nearest = body.y;
#if !defined(ONLY_SECTION) || ONLY_SECTION != 0
    int caps = int(sV.w);
    if ((caps & 1) != 0)
        offerCap(sA.xyz, sClipA, true, origin, direction, body, from, nearest);
    if ((caps & 2) != 0)
        offerCap(sB.xyz, sClipB, false, origin, direction, body, from, nearest);
#endif
    return nearest;
}

float parameter(vec3 x)
{
    vec3 p = x - sA.xyz;
    bool freeA = sClipA == vec3(0.0), freeB = sClipB == vec3(0.0);
    float y = 0.0, len = 0.0;
    if (SECTION == sectionRound) {
        len = roundLength;
        y = dot(p, roundAxis);
        float rho = sqrt(max(0.0, dot(p, p) - y * y));
        y = cosine2 > 0.0 ? y - rho * sine * inversesqrt(cosine2) : sA.w >= sB.w ? 0.0 : len;
    } else if (freeA || freeB) {
        vec3 axis = sB.xyz - sA.xyz;
        len = length(axis);
        y = len > 0.0 ? dot(p, axis) / len : 0.0;
    }
    float fA = freeA ? y : dot(p, sClipA), fB = freeB ? y - len : dot(x - sB.xyz, sClipB);
    return fA - fB > 0.0 ? clamp(fA / (fA - fB), 0.0, 1.0) : 0.5;
}

// Straight, in blend space.
vec4 colourAt(float t)
{
#if defined(UNIFORM_COLOUR) && defined(UNIFORM_OPACITY)
    return sColourA;
#elif defined(UNIFORM_COLOUR)
    return vec4(sColourA.rgb, mix(sColourA.a, sColourB.a, t));
#else
    vec4 colour = mix(sColourA, sColourB, t);
    return vec4(toBlendSpace(colour.rgb), colour.a);
#endif
}
