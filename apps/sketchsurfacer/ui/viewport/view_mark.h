// A place of the scene that is pointed out: where it is seen from, and how it is marked.
#pragma once

#include "geometry/inspection/ray_tree.h"
#include "geometry/triangle_mesh.h"

#include <QPainter>
#include <QString>
#include <optional>

namespace ductus {

class ViewCamera;

/// A ring around a place, a line to its other side if it has one, and a few words.
struct ViewMark
{
    Vec3 at = Vec3::Zero();
    std::optional<Vec3> other;
    QString text;

    Vec3 centre() const { return other ? Vec3(0.5 * (at + *other)) : at; }
};

/// From where a place on a surface, or what lies between the two sides of a gap, is seen: of many unit
/// directions the one nearest to \a present that \a tree does not block; \a present if there is none.
/// \a beside: what lies nearer than this does not hide it.
Vec3 freeDirection(const ViewMark &mark, const RayTree &tree, const Vec3 &present, double beside);

void paintMark(QPainter &painter, const ViewCamera &camera, const ViewMark &mark);

} // namespace ductus
