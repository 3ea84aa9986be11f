// One instance is a triangle; its vertices are the corners of a box around what is no further
// from it than the tolerance.
layout(location = 0) in vec3 inA;
layout(location = 1) in vec3 inB;
layout(location = 2) in vec3 inC;
layout(location = 3) in uint inElement;

flat out vec3 sA;
flat out vec3 sB;
flat out vec3 sC;
flat out uint sOrder;

uniform float tolerance;

void main()
{
    ElementData e = elements[inElement];
    sA = relativeToEye(e, inA);
    sB = relativeToEye(e, inB);
    sC = relativeToEye(e, inC);
    sOrder = e.order;
    vec3 low = min(sA, min(sB, sC)), high = max(sA, max(sB, sC));
#ifdef VIEW_TOLERANCE
    // The tolerance is along rays, which are longer than their depth away from the middle of the view.
    float margin = tolerance * view.limits.y;
#else
    float margin = tolerance;
#endif
    margin = margin * 1.001 + 1e-6 * length(high - low);
    vec3 at = vec3(gl_VertexID & 1, gl_VertexID >> 1 & 1, gl_VertexID >> 2) * 2.0 - 1.0;
    gl_Position = view.clipFromRelative * vec4(0.5 * (low + high) + at * (0.5 * (high - low) + margin), 1.0);
}
