#include "surfacing/proxy/local/local_field.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double enoughWeight = 0.25; // of the patches; below it the rough field mixes in

double wendland(double r)
{
    const double u = 1.0 - r;
    return u * u * u * u * (4.0 * r + 1.0);
}

} // namespace

LocalField::LocalField(const std::vector<Patch> &patches, std::vector<HermiteField> fields,
                       HermiteField rough)
    : mRough(std::move(rough))
{
    std::vector<double> radii;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        mPieces.push_back({patches[i].centre, patches[i].radius, std::move(fields[i])});
        radii.push_back(patches[i].radius);
    }
    if (radii.empty())
        return;
    // Cells the size of a common patch: few patches a cell, few cells a patch.
    std::nth_element(radii.begin(), radii.begin() + std::ptrdiff_t(radii.size() / 2), radii.end());
    mCellSize = radii[radii.size() / 2];
    for (std::size_t i = 0; i < mPieces.size(); ++i) {
        const Piece &piece = mPieces[i];
        const int reach = int(std::ceil(piece.radius / mCellSize));
        for (int x = -reach; x <= reach; ++x)
            for (int y = -reach; y <= reach; ++y)
                for (int z = -reach; z <= reach; ++z)
                    mPiecesOfCell[cellOf(piece.centre + mCellSize * Vec3(x, y, z))].push_back(int(i));
    }
}

std::uint64_t LocalField::cellOf(const Vec3 &x) const
{
    std::uint64_t key = 0;
    for (int k = 0; k < 3; ++k)
        key =
            (key << 21) | (std::uint64_t(std::int64_t(std::floor(x[k] / mCellSize)) + (1 << 20)) & 0x1fffff);
    return key;
}

LocalField::Blend LocalField::blendAt(const Vec3 &x, bool withGradient) const
{
    Blend blend;
    const auto cell = mPiecesOfCell.find(cellOf(x));
    if (cell == mPiecesOfCell.end())
        return blend;
    for (int i : cell->second) {
        const Piece &piece = mPieces[std::size_t(i)];
        const Vec3 local = (x - piece.centre) / piece.radius;
        const double r2 = local.squaredNorm();
        if (r2 >= 1.0)
            continue;
        const double weight = wendland(std::sqrt(r2));
        blend.weight += weight;
        if (withGradient) {
            Vec3 gradient;
            blend.value += weight * piece.radius * piece.field.valueAndGradient(local, gradient);
            blend.gradient += weight * gradient;
        } else {
            blend.value += weight * piece.radius * piece.field.value(local);
        }
    }
    return blend;
}

double LocalField::roughWeight(double patchWeight) const
{
    const double lack = 1.0 - patchWeight / enoughWeight;
    return lack > 0.0 ? enoughWeight * lack * lack : 0.0;
}

double LocalField::value(const Vec3 &x) const
{
    const Blend blend = blendAt(x, false);
    const double rough = roughWeight(blend.weight);
    return (blend.value + (rough > 0.0 ? rough * mRough.value(x) : 0.0)) / (blend.weight + rough);
}

Vec3 LocalField::normal(const Vec3 &x) const
{
    Blend blend = blendAt(x, true);
    const double rough = roughWeight(blend.weight);
    if (rough > 0.0) {
        Vec3 gradient;
        mRough.valueAndGradient(x, gradient);
        blend.gradient += rough * gradient;
    }
    return blend.gradient.stableNormalized();
}

} // namespace ductus
