#include "imaging/picture/ground.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace ductus::picture {

namespace {

constexpr int side = 320;     // cells along each edge of the square
constexpr double width = 3.2; // of the square, stage units (the scene's diagonal is 1)
constexpr double cellsPerUnit = side / width;
constexpr double keyShare = 0.35;  // of the light on the ground; the rest is sky
constexpr double lowestLamp = 0.2; // sine of the elevation below which shadows would reach beyond the square

struct Cell
{
    double x, z; // in cells; centres at whole numbers
};

// Where the ray from a lamp through a point meets the ground.
struct Projection
{
    double groundHeight;
    Vec3 towards;

    Cell operator()(const Vec3 &p) const
    {
        const double t = (p.y() - groundHeight) / towards.y();
        return {(p.x() - t * towards.x()) * cellsPerUnit + 0.5 * side - 0.5,
                (p.z() - t * towards.z()) * cellsPerUnit + 0.5 * side - 0.5};
    }
};

int firstCell(double x)
{
    return int(std::clamp(std::ceil(x), 0.0, double(side)));
}

int lastCell(double x)
{
    return int(std::clamp(std::floor(x), -1.0, double(side - 1)));
}

// Coverage 0..255 of each cell; thin tubes cover cells in part.
using Mask = std::vector<std::uint8_t>;

void coverTriangle(Cell a, Cell b, Cell c, Mask &mask)
{
    const auto side2 = [](Cell p, Cell q, double x, double z) {
        return (q.x - p.x) * (z - p.z) - (q.z - p.z) * (x - p.x);
    };
    const double area = side2(a, b, c.x, c.z);
    const double sign = area < 0.0 ? -1.0 : 1.0;
    for (int z = firstCell(std::min({a.z, b.z, c.z})); z <= lastCell(std::max({a.z, b.z, c.z})); ++z) {
        for (int x = firstCell(std::min({a.x, b.x, c.x})); x <= lastCell(std::max({a.x, b.x, c.x})); ++x) {
            if (sign * side2(a, b, x, z) >= 0.0 && sign * side2(b, c, x, z) >= 0.0 &&
                sign * side2(c, a, x, z) >= 0.0)
                mask[std::size_t(z) * side + std::size_t(x)] = 255;
        }
    }
}

void coverTube(Cell a, Cell b, double radius, Mask &mask)
{
    const double reach = radius + 0.5;
    const double dx = b.x - a.x, dz = b.z - a.z;
    const double squared = dx * dx + dz * dz;
    for (int z = firstCell(std::min(a.z, b.z) - reach); z <= lastCell(std::max(a.z, b.z) + reach); ++z) {
        for (int x = firstCell(std::min(a.x, b.x) - reach); x <= lastCell(std::max(a.x, b.x) + reach); ++x) {
            const double along =
                squared > 0.0 ? std::clamp(((x - a.x) * dx + (z - a.z) * dz) / squared, 0.0, 1.0) : 0.0;
            const double ex = x - a.x - along * dx, ez = z - a.z - along * dz;
            const double distance = std::sqrt(ex * ex + ez * ez);
            // A strip of half width 'radius' through a cell of width 1.
            const double cover = std::clamp(reach - distance, 0.0, std::min(1.0, 2.0 * radius));
            std::uint8_t &cell = mask[std::size_t(z) * side + std::size_t(x)];
            cell = std::max(cell, std::uint8_t(255.0 * cover));
        }
    }
}

Mask castBy(const Stage &stage, const Projection &project)
{
    Mask mask(std::size_t(side) * side, 0);
    for (const StageTriangle &triangle : stage.triangles)
        coverTriangle(project(triangle.corners[0]), project(triangle.corners[1]),
                      project(triangle.corners[2]), mask);
    for (const StageTube &tube : stage.tubes) {
        if (!tube.isCrease)
            coverTube(project(tube.a), project(tube.b), std::max(tube.radius, 0.001) * cellsPerUnit, mask);
    }
    return mask;
}

// Three passes of a box filter: near enough to a Gaussian, hides the steps between lamps.
void blur(std::vector<float> &values, int radius)
{
    std::vector<float> line(side);
    const auto blurLine = [&](std::size_t start, std::size_t step) {
        for (int i = 0; i < side; ++i) {
            float sum = 0.0f;
            for (int k = -radius; k <= radius; ++k)
                sum += values[start + step * std::size_t(std::clamp(i + k, 0, side - 1))];
            line[std::size_t(i)] = sum / float(2 * radius + 1);
        }
        for (int i = 0; i < side; ++i)
            values[start + step * std::size_t(i)] = line[std::size_t(i)];
    };
    for (int pass = 0; pass < 3; ++pass) {
        for (std::size_t i = 0; i < side; ++i)
            blurLine(i * side, 1);
        for (std::size_t i = 0; i < side; ++i)
            blurLine(i, side);
    }
}

} // namespace

Ground::Ground(const Stage &stage, const Lights &lights) : mHeight(stage.groundHeight)
{
    if (stage.isEmpty())
        return;
    struct Share
    {
        Vec3 towards;
        double share;
    };
    std::vector<Share> lamps;
    double sky = 0.0, key = 0.0;
    const auto collect = [&](const std::vector<Lamp> &from, double &total) {
        for (const Lamp &lamp : from) {
            if (lamp.towards.y() > lowestLamp) {
                lamps.push_back({lamp.towards, lamp.strength * lamp.towards.y()});
                total += lamps.back().share;
            }
        }
    };
    collect(lights.sky, sky);
    const std::size_t skyCount = lamps.size();
    collect(lights.key, key);
    for (std::size_t i = 0; i < lamps.size(); ++i)
        lamps[i].share *= i < skyCount ? (1.0 - keyShare) / sky : keyShare / key;

    std::vector<Mask> masks(lamps.size());
    parallelFor(0, lamps.size(), [&](std::size_t i) {
        masks[i] = castBy(stage, {mHeight, lamps[i].towards});
    });
    mShadow.assign(std::size_t(side) * side, 0.0f);
    parallelFor(
        0, mShadow.size(),
        [&](std::size_t cell) {
            double sum = 0.0;
            for (std::size_t i = 0; i < lamps.size(); ++i)
                sum += lamps[i].share * masks[i][cell] / 255.0;
            mShadow[cell] = float(sum);
        },
        4096);
    blur(mShadow, 1);
}

float Ground::at(int i, int j) const
{
    return mShadow[std::size_t(std::clamp(j, 0, side - 1)) * side + std::size_t(std::clamp(i, 0, side - 1))];
}

double Ground::shadow(double x, double z) const
{
    if (mShadow.empty())
        return 0.0;
    const double fromCentre = std::sqrt(x * x + z * z) / (0.5 * width);
    if (!(fromCentre < 1.0))
        return 0.0;
    const double u = x * cellsPerUnit + 0.5 * side - 0.5;
    const double v = z * cellsPerUnit + 0.5 * side - 0.5;
    const int i = int(std::floor(u)), j = int(std::floor(v));
    const double fu = u - i, fv = v - j;
    const double value = (1.0 - fv) * ((1.0 - fu) * double(at(i, j)) + fu * double(at(i + 1, j))) +
                         fv * ((1.0 - fu) * double(at(i, j + 1)) + fu * double(at(i + 1, j + 1)));
    const double fade = std::clamp((1.0 - fromCentre) / 0.5, 0.0, 1.0);
    return value * fade * fade * (3.0 - 2.0 * fade);
}

} // namespace ductus::picture
