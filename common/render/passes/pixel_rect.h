// Where on the frame something is: rectangles of pixels, rows from the bottom up as OpenGL counts them.
#pragma once

#include "painting/reference/frame_camera.h"

#include <algorithm>

namespace ductus {

struct PixelRect
{
    int left = 0, bottom = 0, right = 0, top = 0; // right and top are outside

    bool isEmpty() const { return left >= right || bottom >= top; }
    int width() const { return right - left; }
    int height() const { return top - bottom; }
    PixelRect cutBy(const PixelRect &other) const
    {
        return {std::max(left, other.left), std::max(bottom, other.bottom), std::min(right, other.right),
                std::min(top, other.top)};
    }
    /// The smallest that holds both.
    PixelRect with(const PixelRect &other) const
    {
        if (isEmpty())
            return other;
        if (other.isEmpty())
            return *this;
        return {std::min(left, other.left), std::min(bottom, other.bottom), std::max(right, other.right),
                std::max(top, other.top)};
    }
};

/// Finds balls on the frame.
class ScreenFinder
{
public:
    ScreenFinder(const FrameCamera &camera, int width, int height);

    /// Pixels a ball of the scene may touch; empty if it cannot be seen.
    PixelRect rect(const Vec3 &centre, double radius) const;
    /// Pixels across a length of the scene at the ball's nearest point; infinity with the eye inside.
    double pixels(const Vec3 &centre, double radius, double length) const;

    /// Whether the eye is so far outside that a card across the view may stand for a ball and what is in it.
    bool isFar(const Vec3 &centre, double radius) const;

private:
    Eigen::Matrix3d mCameraFromScene;
    Vec3 mEye;
    double mLeft, mDown, mPixelsPerTangentX, mPixelsPerTangentY;
    int mWidth, mHeight;
    double mNearDepth;
};

} // namespace ductus
