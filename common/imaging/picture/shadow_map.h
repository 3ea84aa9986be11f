// What a far lamp sees: for each cell of a square grid across its rays the height of the first surface they
// meet.
#pragma once

#include "imaging/picture/stage.h"

namespace ductus::picture {

class ShadowMap
{
public:
    /// Draws the triangles of \a stage as seen from the unit direction \a towards; \a side cells along each
    /// axis.
    ShadowMap(const Stage &stage, const Vec3 &towards, int side);

    /// Share of the light that reaches \a point, 0..1, smooth across cells. Surfaces less than \a bias nearer
    /// to the lamp than the point cast no shadow on it.
    double lit(const Vec3 &point, double bias) const;

    /// Width of a cell in stage units: shadows are no finer than that.
    double cellSize() const { return 1.0 / mCellsPerUnit; }

private:
    void draw(const StageTriangle &triangle);
    float heightAt(int x, int y) const
    {
        return mHeights[std::size_t(y) * std::size_t(mSide) + std::size_t(x)];
    }

    int mSide;
    double mCellsPerUnit;
    Vec3 mAcross, mAlong, mTowards; // orthonormal
    std::vector<float> mHeights;
};

} // namespace ductus::picture
