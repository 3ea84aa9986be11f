// The shadow a scene throws on the ground below it: how much of the lamps' light each place of a square
// misses.
#pragma once

#include "imaging/picture/lights.h"
#include "imaging/picture/stage.h"

namespace ductus::picture {

class Ground
{
public:
    /// \a stage casts, surfaces and tubes alike; creases do not. Empty stages cast nothing.
    Ground(const Stage &stage, const Lights &lights);

    double height() const { return mHeight; }

    /// 0 in full light .. 1 where neither key nor sky is seen; fades out towards the edge of the square.
    double shadow(double x, double z) const;

private:
    float at(int i, int j) const;

    double mHeight = 0.0;
    std::vector<float> mShadow;
};

} // namespace ductus::picture
