#include "sketchsurfacer/ui/viewport/view_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ductus {

namespace {

constexpr double radiansPerPixel = 0.0085;
constexpr double steepest = 0.4999 * std::numbers::pi; // straight down would lose the horizon

} // namespace

void ViewCamera::setViewport(const QSizeF &size)
{
    mViewport = {std::max(1.0, size.width()), std::max(1.0, size.height())};
}

Vec3 ViewCamera::forward() const
{
    const double c = std::cos(mElevation), s = std::sin(mElevation);
    // Azimuth 0 looks along -z (y up) or along +y (z up), as in imaging/picture_scene.h.
    if (mUpAxis == UpAxis::Z)
        return Vec3(-c * std::sin(mAzimuth), c * std::cos(mAzimuth), -s);
    return Vec3(-c * std::sin(mAzimuth), -s, -c * std::cos(mAzimuth));
}

Vec3 ViewCamera::right() const
{
    return forward().cross(worldUp()).normalized();
}

double ViewCamera::halfHeight() const
{
    return mDistance * std::tan(0.5 * fieldOfViewDegrees() * std::numbers::pi / 180.0);
}

double ViewCamera::unitsPerPixel(const Vec3 &point) const
{
    const double atTarget = 2.0 * halfHeight() / mViewport.height();
    if (!mPerspective)
        return atTarget;
    return atTarget * std::max(1e-9, (point - eye()).dot(forward())) / mDistance;
}

void ViewCamera::frame(const Box3 &box)
{
    if (box.isEmpty())
        return;
    const double radius = std::max(0.5 * box.diagonal(), 1e-9);
    const double half = 0.5 * fieldOfViewDegrees() * std::numbers::pi / 180.0;
    const double aspect = mViewport.width() / mViewport.height();
    const double narrow = std::atan(std::tan(half) * std::min(1.0, aspect));
    mTarget = box.centre();
    mPivot.reset();
    mDistance = 1.02 * radius / std::sin(narrow);
    // The sphere is a cautious bound: come nearer until a corner of the box touches the margin. Near corners
    // grow faster than the distance shrinks, so this takes a few rounds.
    for (int round = 0; round < 8; ++round) {
        double largest = 0.0;
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 p(corner & 1 ? box.max.x() : box.min.x(), corner & 2 ? box.max.y() : box.min.y(),
                         corner & 4 ? box.max.z() : box.min.z());
            const std::optional<QPointF> at = project(p);
            if (!at)
                return;
            largest = std::max(largest, std::abs(2.0 * at->x() / mViewport.width() - 1.0));
            largest = std::max(largest, std::abs(2.0 * at->y() / mViewport.height() - 1.0));
        }
        const double deepest =
            (box.max - box.min).cwiseProduct(forward()).cwiseAbs().sum() / 2.0; // corner to centre
        mDistance = std::max(deepest + (mDistance - deepest) * largest / 0.86, 1.05 * deepest);
    }
}

void ViewCamera::setPreset(ViewPreset preset)
{
    constexpr double quarter = 0.5 * std::numbers::pi;
    switch (preset) {
    case ViewPreset::Front:
        mAzimuth = 0.0, mElevation = 0.0;
        break;
    case ViewPreset::Back:
        mAzimuth = 2.0 * quarter, mElevation = 0.0;
        break;
    case ViewPreset::Right:
        mAzimuth = quarter, mElevation = 0.0;
        break;
    case ViewPreset::Left:
        mAzimuth = -quarter, mElevation = 0.0;
        break;
    case ViewPreset::Top:
        mAzimuth = 0.0, mElevation = steepest;
        break;
    case ViewPreset::Bottom:
        mAzimuth = 0.0, mElevation = -steepest;
        break;
    case ViewPreset::ThreeQuarter:
        mAzimuth = 0.61, mElevation = 0.42;
        break;
    }
}

void ViewCamera::lookFrom(const Vec3 &direction)
{
    const Vec3 d = direction.normalized();
    const bool isZ = mUpAxis == UpAxis::Z;
    mElevation = std::clamp(std::asin(std::clamp(isZ ? d.z() : d.y(), -1.0, 1.0)), -steepest, steepest);
    mAzimuth = isZ ? std::atan2(d.x(), -d.y()) : std::atan2(d.x(), d.z());
    mPivot.reset();
}

ViewCamera ViewCamera::towards(const ViewCamera &other, double share) const
{
    ViewCamera between = other;
    const double round = std::remainder(other.mAzimuth - mAzimuth, 2.0 * std::numbers::pi);
    between.mAzimuth = mAzimuth + share * round;
    between.mElevation = (1.0 - share) * mElevation + share * other.mElevation;
    between.mTarget = (1.0 - share) * mTarget + share * other.mTarget;
    between.mDistance = std::pow(mDistance, 1.0 - share) * std::pow(other.mDistance, share);
    between.mPivot.reset();
    return share < 1.0 ? between : other;
}

void ViewCamera::orbit(const QPointF &pixels)
{
    const Vec3 pivot = mPivot.value_or(mTarget);
    const Vec3 offset = mTarget - pivot;
    const Vec3 inView(offset.dot(right()), offset.dot(up()), offset.dot(forward()));
    mAzimuth -= radiansPerPixel * pixels.x();
    mElevation = std::clamp(mElevation + radiansPerPixel * pixels.y(), -steepest, steepest);
    mTarget = pivot + inView.x() * right() + inView.y() * up() + inView.z() * forward();
}

void ViewCamera::turn(double rounds)
{
    mPivot.reset();
    mAzimuth = std::remainder(mAzimuth + rounds * 2.0 * std::numbers::pi, 2.0 * std::numbers::pi);
}

void ViewCamera::pan(const QPointF &pixels)
{
    const double scale = 2.0 * halfHeight() / mViewport.height();
    mTarget += scale * (-pixels.x() * right() + pixels.y() * up());
    mPivot.reset();
}

void ViewCamera::zoom(double factor, const QPointF &position)
{
    const Vec3 before = onViewPlane(position, mTarget);
    mDistance *= factor;
    const Vec3 after = onViewPlane(position, mTarget);
    mTarget += before - after;
}

ViewRay ViewCamera::ray(const QPointF &position) const
{
    const double scale = 2.0 * halfHeight() / mViewport.height();
    const double x = (position.x() - 0.5 * mViewport.width()) * scale;
    const double y = (0.5 * mViewport.height() - position.y()) * scale;
    const Vec3 inPlane = mTarget + x * right() + y * up();
    if (mPerspective)
        return {eye(), (inPlane - eye()).normalized()};
    return {inPlane - 100.0 * mDistance * forward(), forward()};
}

std::optional<QPointF> ViewCamera::project(const Vec3 &point) const
{
    const Vec3 offset = point - eye();
    const double depth = offset.dot(forward());
    if (mPerspective && depth <= 1e-9 * mDistance)
        return std::nullopt;
    const double scale = 0.5 * mViewport.height() / halfHeight() * (mPerspective ? mDistance / depth : 1.0);
    return QPointF(0.5 * mViewport.width() + scale * offset.dot(right()),
                   0.5 * mViewport.height() - scale * offset.dot(up()));
}

Vec3 ViewCamera::onViewPlane(const QPointF &position, const Vec3 &through) const
{
    const ViewRay r = ray(position);
    return r.origin + r.direction * ((through - r.origin).dot(forward()) / r.direction.dot(forward()));
}

} // namespace ductus
