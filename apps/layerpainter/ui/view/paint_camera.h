// PaintCamera: the eye of the canvas, turning around a point it looks at; the horizon stays level.
#pragma once

#include "painting/reference/frame_camera.h"

#include <QPointF>
#include <QSizeF>
#include <optional>

namespace ductus {

struct PaintRay
{
    Vec3 origin = Vec3::Zero();
    Vec3 direction = -Vec3::UnitZ(); // unit
};

class PaintCamera
{
public:
    /// In logical pixels, like all positions below; never empty.
    void setViewport(const QSizeF &size);
    QSizeF viewport() const { return mViewport; }

    /// Looks as \a key does, and turns around what is \a distance before it.
    void set(const CameraKey &key, double distance);
    CameraKey key() const;
    FrameCamera frame() const;

    void orbit(const QPointF &pixels);
    void pan(const QPointF &pixels);
    /// \a factor < 1 comes nearer; what is under \a position stays there.
    void zoom(double factor, const QPointF &position);
    /// Turns around \a point from now on; the picture does not jump.
    void setPivotDepth(const Vec3 &point);

    Vec3 eye() const { return mPivot - mDistance * forward(); }
    Vec3 pivot() const { return mPivot; }
    Vec3 forward() const;
    Vec3 right() const;
    Vec3 up() const { return right().cross(forward()); }

    PaintRay ray(const QPointF &position) const;
    /// Where \a point lands; nothing behind the eye.
    std::optional<QPointF> project(const Vec3 &point) const;
    /// Under \a position in the plane through \a through that faces the eye.
    Vec3 onPlane(const QPointF &position, const Vec3 &through) const;
    /// Scene units a pixel covers at \a point.
    double unitsPerPixel(const Vec3 &point) const;

private:
    double halfTangent() const;

    QSizeF mViewport = {640, 480};
    Vec3 mPivot = Vec3::Zero();
    double mDistance = 3;
    double mAzimuth = 0;   // radians around y, 0 looks along -z
    double mElevation = 0; // radians, > 0 looks down
    double mViewDegrees = 40;
};

} // namespace ductus
