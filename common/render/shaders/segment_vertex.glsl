// One instance is a segment of a stroke (painting/coverage/section.h); its vertices are the corners of a box around it
// or, from afar, of a card that hides what the box hides: a third of the triangles.
layout(location = 0) in vec4 inA;       // position, half width; element's space
layout(location = 1) in vec4 inB;
layout(location = 2) in vec4 inU;       // w: section
layout(location = 3) in vec4 inV;       // w: caps
layout(location = 4) in vec4 inClipA;
layout(location = 5) in vec4 inClipB;
layout(location = 6) in vec4 inColourA; // linear; w: opacity
layout(location = 7) in vec4 inColourB;
layout(location = 8) in uint inElement;
layout(location = 9) in vec4 inReachA;  // scene's space
layout(location = 10) in vec4 inReachB;

flat out vec4 sA;
flat out vec4 sB;
flat out vec4 sU; // w: section; of round segments: the axis
flat out vec4 sV; // w: caps; of round segments: length, sine of the mantle's slope, squared cosine (0: no mantle)
flat out vec3 sClipA;
flat out vec3 sClipB;
flat out vec4 sColourA; // linear; in blend space if UNIFORM_COLOUR
flat out vec4 sColourB;
flat out uvec4 sElement; // id, order, stack
#ifdef SURFACE_TOLERANCE
flat out vec3 sReachA;
flat out vec3 sReachB;
#endif

uniform float tolerance;   // 0 for substrates
uniform vec4 layerColour; // linear; w = 1: goes before the elements' own

const float seamSlack = 1e-3;
const float ellipseThickness = 0.3;

vec3 unitOr0(vec3 v)
{
    float l = length(v);
    return l > 0.5 ? v / l : vec3(0.0);
}

vec3 perpendicular(vec3 v)
{
    return normalize(abs(v.x) < 0.6 ? vec3(0.0, v.z, -v.y) : vec3(-v.z, 0.0, v.x));
}

struct Box
{
    vec3 centre;
    vec3 x, y, z;
};

// How far a section of a radius sticks out along the axis behind a plane that is tilted against it.
float beyondPlane(vec3 normal, vec3 along, float radius, float slack)
{
    float c = dot(normal, along);
    return c > 0.1 ? min((slack + radius * sqrt(max(0.0, 1.0 - c * c))) / c, radius + slack) : radius + slack;
}

Box roundBox(vec3 a, float ra, vec3 b, float rb, vec3 clipA, vec3 clipB, float margin)
{
    vec3 along = b - a;
    float len = length(along);
    along = len > 0.0 ? along / len : vec3(1.0, 0.0, 0.0);
    float radius = max(ra, rb), slack = 2.0 * seamSlack * radius;
    // A ball larger than the other may swallow it.
    float low = -min(max(ra, rb - len), clipA == vec3(0.0) ? radius : beyondPlane(clipA, along, radius, slack));
    float high = len + min(max(rb, ra - len), clipB == vec3(0.0) ? radius : beyondPlane(clipB, along, radius, slack));
    low -= margin + slack;
    high += margin + slack;
    // Turned towards the eye the box hides the least of what is behind.
    vec3 side = cross(along, a + b);
    float sideLength = length(side);
    side = sideLength > 1e-4 * length(a + b) ? side / sideLength : perpendicular(along);
    radius += margin + slack;
    return Box(a + 0.5 * (low + high) * along, 0.5 * (high - low) * along, radius * side, radius * cross(along, side));
}

Box flatBox(vec3 a, float ra, vec3 b, float rb, vec3 u, vec3 v, vec3 clipA, vec3 clipB, float thickness, float margin)
{
    vec3 axis = b - a;
    float radius = max(ra, rb), slack = 2.0 * seamSlack * radius;
    float det = abs(dot(axis, cross(u, v)));
    float outU = radius * abs(dot(u, clipA)) + radius * thickness * abs(dot(v, clipA)) + slack;
    float low = -outU / max(dot(axis, clipA), 1e-20);
    float outB = radius * abs(dot(u, clipB)) + radius * thickness * abs(dot(v, clipB)) + slack;
    float high = 1.0 + outB / max(dot(axis, clipB), 1e-20);
    float margin2 = (margin + slack) / max(det, 1e-20);
    low -= margin2 * length(cross(u, v));
    high += margin2 * length(cross(u, v));
    return Box(a + 0.5 * (low + high) * axis, 0.5 * (high - low) * axis,
               (radius + margin2 * length(cross(v, axis))) * u,
               (radius * thickness + margin2 * length(cross(axis, u))) * v);
}

Box ribbonBox(vec3 a, float ra, vec3 b, float rb, vec3 u, vec3 v, float margin)
{
    vec3 left = ra * u, right = rb * v;
    vec3 across = dot(u, v) >= 0.0 ? normalize(u + v) : u;
    vec3 axis = b - a;
    vec3 rest = axis - dot(axis, across) * across;
    float l = length(rest);
    vec3 along = l > 0.0 ? rest / l : perpendicular(across);
    mat3 axes = mat3(along, across, cross(along, across));
    vec3 p0 = -left * axes, p1 = left * axes, p2 = (axis - right) * axes, p3 = (axis + right) * axes;
    vec3 low = min(min(p0, p1), min(p2, p3)), high = max(max(p0, p1), max(p2, p3));
    vec3 middle = 0.5 * (low + high), extent = 0.5 * (high - low) + margin + 2.0 * seamSlack * max(ra, rb);
    return Box(a + axes * middle, extent.x * axes[0], extent.y * axes[1], extent.z * axes[2]);
}

// How much of the half of a round segment that is turned away from the eye shows skin, 0..1: none of an even tube's
// between two others, but all of its free ends' and of steep cones'.
float shownBehind(vec3 a, float ra, vec3 b, float rb, vec3 towardsEye, vec3 clipA, vec3 clipB)
{
    vec3 along = b - a;
    float len = length(along);
    along = len > 0.0 ? along / len : vec3(1.0, 0.0, 0.0);
    float even = min(dot(along, clipA), dot(along, clipB)); // 0 at free ends
    if (even < 0.8)
        return 1.0;
    float slope = (abs(ra - rb) / max(len, 1e-30) + sqrt(max(1.0 - even * even, 0.0))) / (even * even);
    float height = -dot(a, towardsEye), beyond = max(abs(dot(a, along)), abs(dot(b, along)));
    return height > 0.0 ? min(slope * beyond / height, 1.0) : 1.0;
}

// A corner, -1 or 1, of a card across the view that hides a box whose y is square to it.
vec3 cardCorner(Box box, vec2 corner)
{
    float away = length(box.centre);
    vec3 forward = box.centre / away, side = normalize(box.y), up = cross(forward, side);
    vec2 x = vec2(dot(box.x, up), dot(box.x, forward)), z = vec2(dot(box.z, up), dot(box.z, forward));
    vec2 middle = vec2(0.0, away);
    vec2 c0 = middle + x + z, c1 = middle + x - z, c2 = middle - x + z, c3 = middle - x - z;
    vec4 tangents = vec4(c0.x / c0.y, c1.x / c1.y, c2.x / c2.y, c3.x / c3.y);
    vec2 low = min(tangents.xy, tangents.zw), high = max(tangents.xy, tangents.zw);
    float nearest = min(min(c0.y, c1.y), min(c2.y, c3.y));
    float height = corner.y > 0.0 ? max(high.x, high.y) : min(low.x, low.y);
    return away * (forward + corner.x * length(box.y) / nearest * side + height * up);
}

void main()
{
    ElementData e = elements[inElement];
    vec3 a = relativeToEye(e, inA.xyz), b = relativeToEye(e, inB.xyz);
    float ra = inA.w * e.scale, rb = inB.w * e.scale;
    vec3 u = unitOr0(turned(e, inU.xyz)), v = unitOr0(turned(e, inV.xyz));
    vec3 clipA = unitOr0(turned(e, inClipA.xyz)), clipB = unitOr0(turned(e, inClipB.xyz));
    int section = int(inU.w * 32767.0 + 0.5);

    Box box;
    if (section == 0)
        box = roundBox(a, ra, b, rb, clipA, clipB, tolerance);
    else if (section == 3)
        box = ribbonBox(a, ra, b, rb, u, v, tolerance);
    else
        box = flatBox(a, ra, b, rb, u, v, clipA, clipB, section == 1 ? ellipseThickness : 1.0, tolerance);
    if (dot(box.x, cross(box.y, box.z)) < 0.0)
        box.x = -box.x;
    vec3 at = vec3(gl_VertexID & 1, gl_VertexID >> 1 & 1, gl_VertexID >> 2) * 2.0 - 1.0;
    vec3 corner;
    if (gl_VertexID < 8) {
        corner = box.centre + at.x * box.x + at.y * box.y + at.z * box.z;
    } else { // of round segments only
#ifdef SKIN_ONLY
        float behind = shownBehind(a, ra, b, rb, normalize(box.z), clipA, clipB);
        box.centre += 0.5 * (1.0 - behind) * box.z;
        box.z *= 0.5 * (1.0 + behind);
#endif
        corner = cardCorner(box, at.xy);
    }
    gl_Position = view.clipFromRelative * vec4(corner, 1.0);

    sA = vec4(a, ra);
    sB = vec4(b, rb);
    sU = vec4(u, float(section));
    sV = vec4(v, floor(inV.w * 32767.0 + 0.5));
    if (section == 0) {
        vec3 axis = b - a;
        float len = length(axis), sine = (ra - rb) / max(len, 1e-30);
        bool hasMantle = len > abs(ra - rb);
        sU = vec4(len > 0.0 ? axis / len : vec3(0.0), 0.0);
        sV = vec4(len, hasMantle ? sine : 0.0, hasMantle ? 1.0 - sine * sine : 0.0, 0.0);
    }
    sClipA = clipA;
    sClipB = clipB;
    sColourA = layerColour.w > 0.5 ? vec4(layerColour.rgb, inColourA.w) : inColourA;
    sColourB = layerColour.w > 0.5 ? vec4(layerColour.rgb, inColourB.w) : inColourB;
#ifdef UNIFORM_COLOUR
    sColourA.rgb = toBlendSpace(sColourA.rgb);
#endif
    sElement = uvec4(e.elementId, e.order, e.stackId, 0u);
#ifdef SURFACE_TOLERANCE
    sReachA = unitOr0(inReachA.xyz);
    sReachB = unitOr0(inReachB.xyz);
#endif
}
