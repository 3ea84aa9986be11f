// Behind the surface point, triangles that look away from it less those that look towards it: z-fail counting
// without a stencil, right with the eye inside too.
in vec3 vRelative;

layout(location = 0) out float outCount;

void main()
{
    uvec2 found = FRAME_TEXEL(surfaces).xy;
    if (!isColoured(found) || dot(vRelative, view.forward.xyz) <= uintBitsToFloat(found.y))
        discard;
    outCount = gl_FrontFacing ? -1.0 : 1.0;
}
