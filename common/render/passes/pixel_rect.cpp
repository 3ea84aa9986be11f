#include "render/passes/pixel_rect.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace ductus {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Tangents between which a disc at (x, depth) is seen from the origin; none if it is behind.
std::optional<std::pair<double, double>> tangents(double x, double depth, double radius)
{
    const double distance = std::hypot(x, depth);
    if (distance <= radius)
        return std::pair{-infinity, infinity};
    const double middle = std::atan2(x, depth), half = std::asin(radius / distance);
    const double low = middle - half, high = middle + half, quarter = std::numbers::pi / 2;
    if (low >= quarter || high <= -quarter)
        return std::nullopt;
    return std::pair{low <= -quarter ? -infinity : std::tan(low),
                     high >= quarter ? infinity : std::tan(high)};
}

} // namespace

ScreenFinder::ScreenFinder(const FrameCamera &camera, int width, int height)
    : mCameraFromScene(camera.rotation.conjugate().toRotationMatrix()), mEye(camera.eye), mLeft(camera.left),
      mDown(camera.down), mPixelsPerTangentX(width / (camera.right - camera.left)),
      mPixelsPerTangentY(height / (camera.up - camera.down)), mWidth(width), mHeight(height),
      mNearDepth(camera.nearDepth)
{
}

PixelRect ScreenFinder::rect(const Vec3 &centre, double radius) const
{
    const Vec3 at = mCameraFromScene * (centre - mEye);
    const auto x = tangents(at[0], -at[2], radius), y = tangents(at[1], -at[2], radius);
    if (!x || !y)
        return {};
    const auto pixel = [](double tangent, double from, double scale, int size, double margin) {
        return int(std::clamp((tangent - from) * scale + margin, 0.0, double(size)));
    };
    // A pixel around it: rounding.
    return {pixel(x->first, mLeft, mPixelsPerTangentX, mWidth, -1),
            pixel(y->first, mDown, mPixelsPerTangentY, mHeight, -1),
            pixel(x->second, mLeft, mPixelsPerTangentX, mWidth, 2),
            pixel(y->second, mDown, mPixelsPerTangentY, mHeight, 2)};
}

double ScreenFinder::pixels(const Vec3 &centre, double radius, double length) const
{
    const double depth = (centre - mEye).norm() - radius;
    return depth > 0 ? length * std::max(mPixelsPerTangentX, mPixelsPerTangentY) / depth : infinity;
}

bool ScreenFinder::isFar(const Vec3 &centre, double radius) const
{
    // Boxes of segments reach beyond the ball, by less than its diameter.
    const Vec3 at = mCameraFromScene * (centre - mEye);
    return at.norm() > 4 * radius && -at[2] > mNearDepth + radius;
}

} // namespace ductus
