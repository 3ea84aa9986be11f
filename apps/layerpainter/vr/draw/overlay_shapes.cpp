#include "layerpainter/vr/draw/overlay_shapes.h"

#include <utility>

namespace ductus {

void OverlayShapes::clear()
{
    mVertices.clear();
    mParts.clear();
}

void OverlayShapes::startPart(std::uint32_t texture)
{
    if (mParts.empty() || mParts.back().texture != texture || texture != 0)
        mParts.push_back({int(mVertices.size()), 0, texture});
}

void OverlayShapes::add(const Vec3 &at, float u, float v, const Colour &c)
{
    mVertices.push_back({{float(at.x()), float(at.y()), float(at.z())}, {u, v}, {c[0], c[1], c[2], c[3]}});
    ++mParts.back().count;
}

void OverlayShapes::addBall(const Vec3 &centre, double radius, const Colour &colour)
{
    startPart(0);
    // An octahedron whose faces have their light from above: small enough to look round.
    for (int face = 0; face < 8; ++face) {
        const Vec3 corners[3] = {
            {face & 1 ? 1.0 : -1.0, 0, 0}, {0, face & 2 ? 1.0 : -1.0, 0}, {0, 0, face & 4 ? 1.0 : -1.0}};
        Colour shade = colour;
        shade.head<3>() *= face & 2 ? 1.f : 0.65f;
        for (const Vec3 &corner : corners)
            add(centre + radius * corner, 0, 0, shade);
    }
}

void OverlayShapes::addLine(const Vec3 &from, const Vec3 &to, double width, const Colour &colour)
{
    const Vec3 way = to - from;
    if (way.norm() < 1e-9)
        return;
    startPart(0);
    const Vec3 across = way.unitOrthogonal() * 0.5 * width, up = way.normalized().cross(across);
    for (const Vec3 &side : {across, up})
        for (const auto &[end, sign] :
             {std::pair(from, -1), {from, 1}, {to, 1}, {from, -1}, {to, 1}, {to, -1}})
            add(end + sign * side, 0, 0, colour);
}

void OverlayShapes::addPanel(const std::array<Vec3, 4> &corners, std::uint32_t texture)
{
    startPart(texture);
    static constexpr float places[4][2] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    for (const int i : {0, 1, 2, 0, 2, 3})
        add(corners[std::size_t(i)], places[i][0], places[i][1], Colour::Ones());
}

} // namespace ductus
