#include "layerpainter/ui/view/paint_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ductus {

namespace {

constexpr double radiansPerPixel = 0.007;
constexpr double steepest = 0.4995 * std::numbers::pi;

} // namespace

void PaintCamera::setViewport(const QSizeF &size)
{
    mViewport = {std::max(1.0, size.width()), std::max(1.0, size.height())};
}

double PaintCamera::halfTangent() const
{
    return std::tan(mViewDegrees * std::numbers::pi / 360);
}

void PaintCamera::set(const CameraKey &key, double distance)
{
    const Vec3 way = key.rotation * -Vec3::UnitZ();
    mElevation = std::clamp(-std::asin(std::clamp(way.y(), -1.0, 1.0)), -steepest, steepest);
    mAzimuth = std::atan2(-way.x(), -way.z());
    mViewDegrees = key.verticalViewDegrees;
    mDistance = std::max(distance, 1e-6);
    mPivot = key.eye + mDistance * forward();
}

CameraKey PaintCamera::key() const
{
    CameraKey key;
    key.eye = eye();
    Eigen::Matrix3d axes;
    axes << right(), up(), -forward();
    key.rotation = Eigen::Quaterniond(axes).normalized();
    key.verticalViewDegrees = mViewDegrees;
    return key;
}

FrameCamera PaintCamera::frame() const
{
    return FrameCamera::of(key(), mViewport.width() / mViewport.height());
}

Vec3 PaintCamera::forward() const
{
    const double c = std::cos(mElevation);
    return {-c * std::sin(mAzimuth), -std::sin(mElevation), -c * std::cos(mAzimuth)};
}

Vec3 PaintCamera::right() const
{
    return forward().cross(Vec3::UnitY()).normalized();
}

void PaintCamera::orbit(const QPointF &pixels)
{
    mAzimuth -= radiansPerPixel * pixels.x();
    mElevation = std::clamp(mElevation + radiansPerPixel * pixels.y(), -steepest, steepest);
}

void PaintCamera::pan(const QPointF &pixels)
{
    const double scale = 2 * halfTangent() * mDistance / mViewport.height();
    mPivot += scale * (-pixels.x() * right() + pixels.y() * up());
}

void PaintCamera::zoom(double factor, const QPointF &position)
{
    const Vec3 before = onPlane(position, mPivot);
    mDistance = std::clamp(mDistance * factor, 1e-6, 1e9);
    mPivot += before - onPlane(position, mPivot);
}

void PaintCamera::setPivotDepth(const Vec3 &point)
{
    const Vec3 from = eye();
    const double depth = (point - from).dot(forward());
    if (depth <= 1e-9)
        return;
    mDistance = depth;
    mPivot = from + depth * forward();
}

PaintRay PaintCamera::ray(const QPointF &position) const
{
    const double scale = 2 * halfTangent() / mViewport.height();
    const double x = (position.x() - 0.5 * mViewport.width()) * scale;
    const double y = (0.5 * mViewport.height() - position.y()) * scale;
    return {eye(), (forward() + x * right() + y * up()).normalized()};
}

std::optional<QPointF> PaintCamera::project(const Vec3 &point) const
{
    const Vec3 offset = point - eye();
    const double depth = offset.dot(forward());
    if (depth <= 1e-9 * mDistance)
        return std::nullopt;
    const double scale = 0.5 * mViewport.height() / (halfTangent() * depth);
    return QPointF(0.5 * mViewport.width() + scale * offset.dot(right()),
                   0.5 * mViewport.height() - scale * offset.dot(up()));
}

Vec3 PaintCamera::onPlane(const QPointF &position, const Vec3 &through) const
{
    const PaintRay r = ray(position);
    return r.origin + r.direction * ((through - r.origin).dot(forward()) / r.direction.dot(forward()));
}

double PaintCamera::unitsPerPixel(const Vec3 &point) const
{
    return 2 * halfTangent() * std::max(1e-9, (point - eye()).dot(forward())) / mViewport.height();
}

} // namespace ductus
