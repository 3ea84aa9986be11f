#include "imaging/picture/shadow_map.h"

#include <algorithm>
#include <cmath>

namespace ductus::picture {

namespace {

constexpr float nothing = -1e30f;

} // namespace

ShadowMap::ShadowMap(const Stage &stage, const Vec3 &towards, int side)
    : mSide(side), mCellsPerUnit((side - 4) / 1.0), mTowards(towards),
      mHeights(std::size_t(side) * std::size_t(side), nothing)
{
    // The stage fits into a ball of diameter 1 around the origin, which is what the grid covers.
    mAcross = towards.cross(std::abs(towards.y()) < 0.9 ? Vec3::UnitY() : Vec3::UnitX()).normalized();
    mAlong = towards.cross(mAcross);
    for (const StageTriangle &triangle : stage.triangles)
        draw(triangle);
}

void ShadowMap::draw(const StageTriangle &triangle)
{
    double x[3], y[3], h[3];
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 &p = triangle.corners[k];
        x[k] = 0.5 * mSide + mAcross.dot(p) * mCellsPerUnit - 0.5; // cell centres at whole numbers
        y[k] = 0.5 * mSide + mAlong.dot(p) * mCellsPerUnit - 0.5;
        h[k] = mTowards.dot(p);
    }
    const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    if (area == 0.0)
        return;
    const int x0 = std::max(0, int(std::ceil(std::min({x[0], x[1], x[2]}))));
    const int x1 = std::min(mSide - 1, int(std::floor(std::max({x[0], x[1], x[2]}))));
    const int y0 = std::max(0, int(std::ceil(std::min({y[0], y[1], y[2]}))));
    const int y1 = std::min(mSide - 1, int(std::floor(std::max({y[0], y[1], y[2]}))));
    for (int j = y0; j <= y1; ++j) {
        for (int i = x0; i <= x1; ++i) {
            const double w0 = ((x[1] - i) * (y[2] - j) - (x[2] - i) * (y[1] - j)) / area;
            const double w1 = ((x[2] - i) * (y[0] - j) - (x[0] - i) * (y[2] - j)) / area;
            const double w2 = 1.0 - w0 - w1;
            if (w0 < 0.0 || w1 < 0.0 || w2 < 0.0)
                continue;
            float &height = mHeights[std::size_t(j) * std::size_t(mSide) + std::size_t(i)];
            height = std::max(height, float(w0 * h[0] + w1 * h[1] + w2 * h[2]));
        }
    }
}

double ShadowMap::lit(const Vec3 &point, double bias) const
{
    const double x = 0.5 * mSide + mAcross.dot(point) * mCellsPerUnit - 0.5;
    const double y = 0.5 * mSide + mAlong.dot(point) * mCellsPerUnit - 0.5;
    if (!(x >= 0.0 && y >= 0.0 && x < mSide - 1 && y < mSide - 1))
        return 1.0;
    const int i = int(x), j = int(y);
    const double u = x - i, v = y - j;
    const auto height = float(mTowards.dot(point) + bias);
    const auto free = [&](int a, int b) { return heightAt(a, b) <= height ? 1.0 : 0.0; };
    return (1.0 - v) * ((1.0 - u) * free(i, j) + u * free(i + 1, j)) +
           v * ((1.0 - u) * free(i, j + 1) + u * free(i + 1, j + 1));
}

} // namespace ductus::picture
