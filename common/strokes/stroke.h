// Stroke and StrokeSet: the material of the whole suite. A stroke is a polyline in drawing order; the optional
// channels have one value a point or are empty. Order, time and pressure are never thrown away.
#pragma once

#include "base/typed_id.h"
#include "geometry/triangle_mesh.h"

#include <string>
#include <vector>

namespace ductus {

using StrokeId = TypedId<struct StrokeIdTag>;

/// What a stroke means for the surface (surfacing.md section 1).
enum class StrokeRole { Surface, Boundary, Ignored, Inner, Skeletal };

struct Stroke
{
    StrokeId id;
    StrokeRole role = StrokeRole::Surface;
    std::vector<Vec3> points;          // in the set's unit and axes
    std::vector<double> pressure;      // 0..1, one a point, or empty
    std::vector<double> timeSeconds;   // from any origin, one a point, or empty
};

enum class UpAxis { Y, Z };

struct StrokeSet
{
    std::vector<Stroke> strokes;
    double metresPerUnit = 1.0; // as told by the file or the user; 1 where nobody said
    UpAxis upAxis = UpAxis::Y;

    int pointCount() const;
    /// Box of all points of all strokes.
    Box3 box() const;
    /// All points in order.
    std::vector<Vec3> allPoints() const;
};

double polylineLength(const std::vector<Vec3> &points);

} // namespace ductus
