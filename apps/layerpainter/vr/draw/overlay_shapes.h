// OverlayShapes: what is not the painting: hands, the ray, marks of what is chosen, panels. In the room,
// metres.
#pragma once

#include "geometry/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ductus {

class OverlayRenderer;

/// One frame's worth, the same for both eyes.
class OverlayShapes
{
public:
    using Colour = Eigen::Vector4f; // encoded sRGB, straight alpha

    void addBall(const Vec3 &centre, double radius, const Colour &colour);
    /// Seen from all sides as a line of that width.
    void addLine(const Vec3 &from, const Vec3 &to, double width, const Colour &colour);
    /// \a corners counterclockwise from the lower left; \a texture with its rows from the top; hidden by
    /// nothing: a panel inside a stroke could not be used.
    void addPanel(const std::array<Vec3, 4> &corners, std::uint32_t texture);

    void clear();
    bool isEmpty() const { return mVertices.empty(); }

private:
    friend class OverlayRenderer;
    struct Vertex
    {
        float position[3], place[2], colour[4];
    };
    struct Part
    {
        int first = 0, count = 0;
        std::uint32_t texture = 0; // 0: none
    };
    void add(const Vec3 &at, float u, float v, const Colour &colour);
    void startPart(std::uint32_t texture);

    std::vector<Vertex> mVertices;
    std::vector<Part> mParts;
};

} // namespace ductus
