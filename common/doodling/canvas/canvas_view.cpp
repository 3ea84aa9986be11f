#include "doodling/canvas/canvas_view.h"

#include "base/parallel.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double flattest = 1e-4; // cosine; less is seen as a line

// Bilinear; the colour of what is outside is alpha 0.
std::array<double, 4> between(const Image &picture, const Vec2 &pixel)
{
    const double x = pixel.x() - 0.5, y = pixel.y() - 0.5;
    const int left = int(std::floor(x)), top = int(std::floor(y));
    const double right = x - left, low = y - top;
    std::array<double, 4> sum{};
    for (int dy = 0; dy < 2; ++dy)
        for (int dx = 0; dx < 2; ++dx) {
            const int px = std::clamp(left + dx, 0, picture.width - 1);
            const int py = std::clamp(top + dy, 0, picture.height - 1);
            const double weight = (dx ? right : 1.0 - right) * (dy ? low : 1.0 - low);
            const std::uint8_t *p =
                picture.pixels.data() + 4 * (std::size_t(py) * std::size_t(picture.width) + std::size_t(px));
            for (std::size_t c = 0; c < 4; ++c)
                sum[c] += weight * p[c];
        }
    return sum;
}

bool isInside(const Image &picture, const Vec2 &pixel)
{
    return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() <= picture.width && pixel.y() <= picture.height;
}

} // namespace

ShotCamera scaledCamera(const ShotCamera &camera, double factor)
{
    ShotCamera result = camera;
    result.focal *= factor;
    result.centre *= factor;
    return result;
}

CanvasView::CanvasView(const ShotCamera &camera, const CanvasFrame &place) : mPlace(place)
{
    const Eigen::Matrix3d turn = place.worldFromCanvas.toRotationMatrix();
    Eigen::Matrix3d worldFromCanvas; // columns: canvas x, canvas y, its middle as seen from the camera
    worldFromCanvas.col(0) = place.scale * turn.col(0);
    worldFromCanvas.col(1) = place.scale * turn.col(1);
    worldFromCanvas.col(2) = place.position - camera.position();
    Eigen::Matrix3d pixelFromCamera = Eigen::Matrix3d::Identity();
    pixelFromCamera(0, 0) = pixelFromCamera(1, 1) = camera.focal;
    pixelFromCamera.block<2, 1>(0, 2) = camera.centre;
    mPixelFromCanvas = pixelFromCamera * camera.worldFromCamera.linear().transpose() * worldFromCanvas;
    const Vec3 ray = worldFromCanvas.col(2).normalized();
    const double cosine = turn.col(2).dot(ray); // z points away from who draws
    mFacing = std::abs(cosine);
    mIsFromBehind = cosine < 0.0;
    mIsFlat = !(mFacing > flattest);
    mCanvasFromPixel = mIsFlat ? Eigen::Matrix3d::Zero().eval() : mPixelFromCanvas.inverse().eval();
}

std::optional<Vec2> CanvasView::pixelOf(const Vec2 &onCanvas) const
{
    const Vec3 seen = mPixelFromCanvas * onCanvas.homogeneous();
    if (seen.z() <= 0.0)
        return std::nullopt;
    return Vec2(seen.hnormalized());
}

std::optional<Vec2> CanvasView::canvasPointOf(const Vec2 &pixel) const
{
    if (mIsFlat)
        return std::nullopt;
    const Vec3 onCanvas = mCanvasFromPixel * pixel.homogeneous();
    // The inverse takes depth to 1 / depth in the third component: it tells before from behind the camera.
    if (!(onCanvas.z() > 0.0))
        return std::nullopt;
    return Vec2(onCanvas.hnormalized());
}

double CanvasView::depthOf(const Vec2 &onCanvas) const
{
    return mPixelFromCanvas.row(2).dot(onCanvas.homogeneous());
}

Vec3 CanvasView::worldPointOf(const Vec2 &onCanvas) const
{
    return mPlace.position + mPlace.scale * (mPlace.worldFromCanvas * Vec3(onCanvas.x(), onCanvas.y(), 0.0));
}

double CanvasView::pixelsAUnit() const
{
    const double depth = mPixelFromCanvas(2, 2);
    if (!(depth > 0.0))
        return 0.0;
    // The derivative of the projection at the middle.
    const Vec2 middle = mPixelFromCanvas.col(2).hnormalized();
    Eigen::Matrix2d derivative;
    for (int axis = 0; axis < 2; ++axis)
        derivative.col(axis) =
            (mPixelFromCanvas.col(axis).head<2>() - middle * mPixelFromCanvas(2, axis)) / depth;
    const Eigen::Matrix2d squared = derivative.transpose() * derivative;
    const double mean = 0.5 * squared.trace();
    return std::sqrt(mean + std::sqrt(std::max(0.0, mean * mean - squared.determinant())));
}

Image rectified(const Image &picture, const CanvasView &view, const Vec2 &size, int width, int height)
{
    Image result(width, height);
    const double unitX = size.x() / width, unitY = size.y() / height;
    // Where a result's pixel covers several of the picture, several places in it are averaged.
    const double covered = view.pixelsAUnit() * std::max(unitX, unitY);
    const int samples = std::clamp(int(std::ceil(covered)), 1, 4);
    parallelFor(
        0, std::size_t(height),
        [&](std::size_t row) {
            for (int x = 0; x < width; ++x) {
                std::array<double, 4> sum{};
                int seen = 0;
                for (int s = 0; s < samples * samples; ++s) {
                    const double dx = (s % samples + 0.5) / samples, dy = (s / samples + 0.5) / samples;
                    const Vec2 onCanvas((x + dx) * unitX - 0.5 * size.x(),
                                        (double(row) + dy) * unitY - 0.5 * size.y());
                    const std::optional<Vec2> pixel = view.pixelOf(onCanvas);
                    if (!pixel || !isInside(picture, *pixel))
                        continue;
                    const std::array<double, 4> colour = between(picture, *pixel);
                    for (std::size_t c = 0; c < 4; ++c)
                        sum[c] += colour[c];
                    ++seen;
                }
                if (2 * seen < samples * samples)
                    continue;
                std::uint8_t *p = result.pixels.data() + 4 * (row * std::size_t(width) + std::size_t(x));
                for (std::size_t c = 0; c < 4; ++c)
                    p[c] = std::uint8_t(std::lround(sum[c] / seen));
            }
        },
        8);
    return result;
}

} // namespace ductus
