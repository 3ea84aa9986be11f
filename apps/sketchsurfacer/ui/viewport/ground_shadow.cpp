#include "sketchsurfacer/ui/viewport/ground_shadow.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr int resolution = 128;
constexpr double marginShare = 0.35; // around the box, for the blur to fade out

// Three box blurs make nearly a Gaussian; along rows, then transposed, twice makes both ways.
void blurRows(std::vector<double> &grid, int radius)
{
    std::vector<double> row(resolution);
    for (int y = 0; y < resolution; ++y) {
        double *line = grid.data() + std::size_t(y) * resolution;
        double sum = 0.0;
        for (int x = -radius; x < resolution; ++x) {
            if (x + radius < resolution)
                sum += line[x + radius];
            if (x - radius - 1 >= 0)
                sum -= line[x - radius - 1];
            if (x >= 0)
                row[std::size_t(x)] = sum / (2 * radius + 1);
        }
        std::copy(row.begin(), row.end(), line);
    }
}

std::vector<double> transposed(const std::vector<double> &grid)
{
    std::vector<double> turned(grid.size());
    for (int y = 0; y < resolution; ++y)
        for (int x = 0; x < resolution; ++x)
            turned[std::size_t(x) * resolution + std::size_t(y)] =
                grid[std::size_t(y) * resolution + std::size_t(x)];
    return turned;
}

} // namespace

GroundShadow groundShadow(const std::vector<Vec3> &points, UpAxis up, double darkest)
{
    GroundShadow shadow;
    const Box3 box = boundingBox(points);
    if (points.size() < 3 || !(box.diagonal() > 0.0))
        return shadow;
    const int h = up == UpAxis::Z ? 2 : 1; // axis of height
    const int v = up == UpAxis::Z ? 1 : 2;
    const double side = std::max({box.max[0] - box.min[0], box.max[v] - box.min[v], 0.2 * box.diagonal()}) *
                        (1.0 + 2.0 * marginShare);
    shadow.corner = box.centre();
    shadow.corner[0] -= 0.5 * side;
    shadow.corner[v] -= 0.5 * side;
    shadow.corner[h] = box.min[h] - 0.004 * box.diagonal();
    shadow.height = shadow.corner[h];
    shadow.alongU = side * Vec3::UnitX();
    shadow.alongV = side * Vec3::Unit(v);

    std::vector<double> cover(std::size_t(resolution) * resolution, 0.0);
    const double height = std::max(box.max[h] - box.min[h], 1e-12);
    for (const Vec3 &p : points) {
        const int x = std::clamp(int(resolution * (p[0] - shadow.corner[0]) / side), 0, resolution - 1);
        const int y = std::clamp(int(resolution * (p[v] - shadow.corner[v]) / side), 0, resolution - 1);
        double &cell = cover[std::size_t(y) * resolution + std::size_t(x)];
        cell = std::max(cell, 1.0 - 0.75 * (p[h] - box.min[h]) / height);
    }
    for (const int radius : {2, 4, 6}) {
        for (int way = 0; way < 2; ++way) {
            blurRows(cover, radius);
            cover = transposed(cover);
        }
    }
    const double strongest = *std::max_element(cover.begin(), cover.end());
    shadow.image = Image(resolution, resolution);
    for (int y = 0; y < resolution; ++y)
        for (int x = 0; x < resolution; ++x) {
            const double share = cover[std::size_t(y) * resolution + std::size_t(x)] / strongest;
            shadow.image.set(
                x, y,
                {0, 0, 0,
                 std::uint8_t(std::lround(255 * darkest * std::sqrt(share) * std::min(1.0, 4 * share)))});
        }
    return shadow;
}

} // namespace ductus
