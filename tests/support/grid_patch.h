// Rectangular grids of points, the building blocks of the synthetic solids: Coons patches between border
// polylines, flat quadrilaterals, surfaces of revolution; and the curves that border them.
#pragma once

#include "geometry/triangle_mesh.h"

#include <functional>
#include <vector>

namespace ductus {

using Polyline = std::vector<Vec3>;

struct GridPatch
{
    int rows = 0; // points, not cells
    int columns = 0;
    std::vector<Vec3> points; // row after row

    const Vec3 &at(int row, int column) const { return points[std::size_t(row) * columns + column]; }
    Vec3 &at(int row, int column) { return points[std::size_t(row) * columns + column]; }
    Polyline row(int row) const;
    Polyline column(int column) const;
    /// Bilinear; u along the rows (0 = first column), v along the columns, both 0..1.
    Vec3 interpolate(double u, double v) const;
};

/// points(u, v) on an even grid of cells, u and v in 0..1.
GridPatch sampledGrid(int columnCells, int rowCells, const std::function<Vec3(double u, double v)> &point);

/// The bilinearly blended patch [Coons 1967]: bottom and top run left to right and have the same number of
/// points, left and right run bottom to top likewise; corners must coincide.
GridPatch coonsPatch(const Polyline &bottom, const Polyline &top, const Polyline &left,
                     const Polyline &right);

/// Flat or twisted quadrilateral: a -> b along the rows, a -> d along the columns.
GridPatch quadPatch(const Vec3 &a, const Vec3 &b, const Vec3 &c, const Vec3 &d, int columnCells,
                    int rowCells);

/// \a profile (x = radius, y = height; z ignored) turned about the Y axis, \a cells around.
GridPatch revolvedPatch(const Polyline &profile, int cells);

/// cells + 1 points from a to b.
Polyline linePoints(const Vec3 &a, const Vec3 &b, int cells);

/// The natural cubic spline through \a knots (chord-length parameters), cells + 1 points at even arc length.
Polyline splinePoints(const std::vector<Vec3> &knots, int cells);

Polyline reversed(Polyline points);
/// \a first and \a second, which begins where first ends.
Polyline joined(Polyline first, const Polyline &second);
Polyline mapped(Polyline points, const std::function<Vec3(const Vec3 &)> &map);

/// (u, v) pairs (x and y of \a parameters) lifted to \a patch.
Polyline drawnOn(const GridPatch &patch, const Polyline &parameters);
/// A closed ellipse and a closed rectangle (each side subdivided) in parameter space, for details.
Polyline parameterEllipse(double u, double v, double radiusU, double radiusV);
Polyline parameterRectangle(double u0, double v0, double u1, double v1);

} // namespace ductus
