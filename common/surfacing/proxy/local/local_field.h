// A field made of the fields of overlapping patches, blended by smooth weights that end with their balls (a
// partition of unity [Franke, Nielson 1980]; Wendland's C2 function), and of a rough field of the whole shape
// where no patch reaches: so it has a side everywhere, and costs as much as a few patches to evaluate however
// many there are.
#pragma once

#include "surfacing/proxy/local/patch_fit.h"

#include <unordered_map>

namespace ductus {

class LocalField
{
public:
    LocalField() = default;
    /// \a fields beside \a patches, in their frames, outwards.
    LocalField(const std::vector<Patch> &patches, std::vector<HermiteField> fields, HermiteField rough);

    double value(const Vec3 &x) const;

    /// The direction of the blended fields' steepest ascent, unit length: the normal, at points of the
    /// surface.
    Vec3 normal(const Vec3 &x) const;

private:
    struct Piece
    {
        Vec3 centre;
        double radius;
        HermiteField field;
    };

    struct Blend
    {
        double weight = 0.0, value = 0.0; // sums over the patches that reach x
        Vec3 gradient = Vec3::Zero();
    };

    Blend blendAt(const Vec3 &x, bool withGradient) const;
    double roughWeight(double patchWeight) const;
    std::uint64_t cellOf(const Vec3 &x) const;

    std::vector<Piece> mPieces;
    HermiteField mRough;
    double mCellSize = 1.0;
    std::unordered_map<std::uint64_t, std::vector<int>> mPiecesOfCell;
};

} // namespace ductus
