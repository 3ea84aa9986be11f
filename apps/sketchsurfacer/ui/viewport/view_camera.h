// ViewCamera: a turntable camera around a target. Plain geometry: where the eye is, what a pixel sees, where
// a point lands. The viewport's VTK cameras follow it.
#pragma once

#include "geometry/triangle_mesh.h"
#include "strokes/stroke.h"

#include <QPointF>
#include <QSizeF>
#include <optional>

namespace ductus {

enum class ViewPreset { Front, Back, Right, Left, Top, Bottom, ThreeQuarter };

struct ViewRay
{
    Vec3 origin = Vec3::Zero();
    Vec3 direction = Vec3::UnitZ(); // unit
};

class ViewCamera
{
public:
    void setUpAxis(UpAxis axis) { mUpAxis = axis; }
    /// In logical pixels, like all positions below; never empty.
    void setViewport(const QSizeF &size);
    QSizeF viewport() const { return mViewport; }

    void setPerspective(bool on) { mPerspective = on; }
    bool isPerspective() const { return mPerspective; }

    /// Looks at \a box so that all of it is seen, from where the camera is.
    void frame(const Box3 &box);
    void setPreset(ViewPreset preset);
    /// Looks at the target from where \a direction points to, seen from it.
    void lookFrom(const Vec3 &direction);
    /// Between this (0) and \a other (1), the short way round.
    ViewCamera towards(const ViewCamera &other, double share) const;

    /// Drags by \a pixels: orbit keeps the horizon level; pan moves what lies at the target along.
    void orbit(const QPointF &pixels);
    void pan(const QPointF &pixels);
    /// Around the up axis through the target, \a rounds of 360 degrees.
    void turn(double rounds);
    /// \a factor < 1 comes nearer; what is under \a position stays there.
    void zoom(double factor, const QPointF &position);
    /// Turns around \a point from now on, without a jump of the picture.
    void setTarget(const Vec3 &point) { mPivot = point; }

    Vec3 eye() const { return mTarget - mDistance * forward(); }
    Vec3 target() const { return mTarget; }
    Vec3 forward() const;
    Vec3 right() const;
    Vec3 up() const { return right().cross(forward()); }
    Vec3 worldUp() const { return mUpAxis == UpAxis::Z ? Vec3::UnitZ() : Vec3::UnitY(); }
    double distance() const { return mDistance; }
    double fieldOfViewDegrees() const { return 28.0; }
    /// Half the height of what is seen in the target's plane, scene units.
    double halfHeight() const;
    /// Scene units a logical pixel covers at \a point.
    double unitsPerPixel(const Vec3 &point) const;

    ViewRay ray(const QPointF &position) const;
    /// Where \a point lands; nothing if it is behind the eye.
    std::optional<QPointF> project(const Vec3 &point) const;
    /// The point under \a position in the plane through \a through that faces the eye.
    Vec3 onViewPlane(const QPointF &position, const Vec3 &through) const;

    bool operator==(const ViewCamera &) const = default;

private:
    QSizeF mViewport = {640, 480};
    UpAxis mUpAxis = UpAxis::Y;
    bool mPerspective = true;
    Vec3 mTarget = Vec3::Zero();
    std::optional<Vec3> mPivot;
    double mDistance = 3.0;
    double mAzimuth = 0.61;   // radians around the up axis
    double mElevation = 0.42; // radians above the horizon
};

} // namespace ductus
