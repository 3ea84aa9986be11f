#include "support/grid_patch.h"

#include "base/assert.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ductus {

namespace {

/// Second derivatives of the natural cubic spline through \a knots at \a parameters (tridiagonal solve).
std::vector<Vec3> splineCurvatures(const std::vector<Vec3> &knots, const std::vector<double> &parameters)
{
    const std::size_t n = knots.size();
    std::vector<Vec3> second(n, Vec3::Zero()), right(n, Vec3::Zero());
    std::vector<double> ratio(n, 0.0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double before = parameters[i] - parameters[i - 1], after = parameters[i + 1] - parameters[i];
        const double pivot = 2.0 * (before + after) - before * ratio[i - 1];
        ratio[i] = after / pivot;
        const Vec3 slopes = (knots[i + 1] - knots[i]) / after - (knots[i] - knots[i - 1]) / before;
        right[i] = (6.0 * slopes - before * right[i - 1]) / pivot;
    }
    for (std::size_t i = n - 2; i >= 1; --i)
        second[i] = right[i] - ratio[i] * second[i + 1];
    return second;
}

Polyline evenArcLength(const Polyline &fine, int cells)
{
    std::vector<double> length(fine.size(), 0.0);
    for (std::size_t i = 1; i < fine.size(); ++i)
        length[i] = length[i - 1] + (fine[i] - fine[i - 1]).norm();
    Polyline result{fine.front()};
    std::size_t segment = 1;
    for (int k = 1; k < cells; ++k) {
        const double target = length.back() * k / cells;
        while (segment + 1 < fine.size() && length[segment] < target)
            ++segment;
        const double t = (target - length[segment - 1]) / (length[segment] - length[segment - 1]);
        result.push_back(fine[segment - 1] + t * (fine[segment] - fine[segment - 1]));
    }
    result.push_back(fine.back());
    return result;
}

} // namespace

Polyline GridPatch::row(int row) const
{
    const auto begin = points.begin() + std::ptrdiff_t(row) * columns;
    return Polyline(begin, begin + columns);
}

Polyline GridPatch::column(int column) const
{
    Polyline result;
    for (int r = 0; r < rows; ++r)
        result.push_back(at(r, column));
    return result;
}

Vec3 GridPatch::interpolate(double u, double v) const
{
    const double x = std::clamp(u, 0.0, 1.0) * (columns - 1), y = std::clamp(v, 0.0, 1.0) * (rows - 1);
    const int c = std::min(int(x), columns - 2), r = std::min(int(y), rows - 2);
    const double s = x - c, t = y - r;
    return (1 - t) * ((1 - s) * at(r, c) + s * at(r, c + 1)) +
           t * ((1 - s) * at(r + 1, c) + s * at(r + 1, c + 1));
}

GridPatch sampledGrid(int columnCells, int rowCells, const std::function<Vec3(double, double)> &point)
{
    GridPatch patch{rowCells + 1, columnCells + 1, {}};
    for (int r = 0; r <= rowCells; ++r)
        for (int c = 0; c <= columnCells; ++c)
            patch.points.push_back(point(double(c) / columnCells, double(r) / rowCells));
    return patch;
}

GridPatch coonsPatch(const Polyline &bottom, const Polyline &top, const Polyline &left, const Polyline &right)
{
    DUCTUS_ASSERT(bottom.size() == top.size() && left.size() == right.size());
    const auto meet = [](const Vec3 &a, const Vec3 &b) { return (a - b).norm() < 1e-9; };
    DUCTUS_ASSERT(meet(bottom.front(), left.front()) && meet(bottom.back(), right.front()));
    DUCTUS_ASSERT(meet(top.front(), left.back()) && meet(top.back(), right.back()));
    const int columnCells = int(bottom.size()) - 1, rowCells = int(left.size()) - 1;
    GridPatch patch{rowCells + 1, columnCells + 1, {}};
    for (int r = 0; r <= rowCells; ++r) {
        for (int c = 0; c <= columnCells; ++c) {
            const double u = double(c) / columnCells, v = double(r) / rowCells;
            const Vec3 corners = (1 - v) * ((1 - u) * bottom.front() + u * bottom.back()) +
                                 v * ((1 - u) * top.front() + u * top.back());
            patch.points.push_back((1 - v) * bottom[c] + v * top[c] + (1 - u) * left[r] + u * right[r] -
                                   corners);
        }
    }
    return patch;
}

GridPatch quadPatch(const Vec3 &a, const Vec3 &b, const Vec3 &c, const Vec3 &d, int columnCells, int rowCells)
{
    return sampledGrid(columnCells, rowCells, [&](double u, double v) -> Vec3 {
        return (1 - v) * ((1 - u) * a + u * b) + v * ((1 - u) * d + u * c);
    });
}

GridPatch revolvedPatch(const Polyline &profile, int cells)
{
    return sampledGrid(cells, int(profile.size()) - 1, [&](double u, double v) {
        const Vec3 &p = profile[std::size_t(std::lround(v * double(profile.size() - 1)))];
        const double angle = 2.0 * std::numbers::pi * u;
        return Vec3(p.x() * std::cos(angle), p.y(), p.x() * std::sin(angle));
    });
}

Polyline linePoints(const Vec3 &a, const Vec3 &b, int cells)
{
    Polyline result;
    for (int i = 0; i <= cells; ++i)
        result.push_back(a + (b - a) * (double(i) / cells));
    result.back() = b;
    return result;
}

Polyline splinePoints(const std::vector<Vec3> &knots, int cells)
{
    DUCTUS_ASSERT(knots.size() >= 2);
    if (knots.size() == 2)
        return linePoints(knots[0], knots[1], cells);
    std::vector<double> parameters{0.0};
    for (std::size_t i = 1; i < knots.size(); ++i)
        parameters.push_back(parameters.back() + (knots[i] - knots[i - 1]).norm());
    const std::vector<Vec3> second = splineCurvatures(knots, parameters);
    constexpr int fineCells = 200;
    Polyline fine{knots.front()};
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        const double h = parameters[i + 1] - parameters[i];
        for (int k = 1; k <= fineCells; ++k) {
            const double b = double(k) / fineCells, a = 1.0 - b;
            fine.push_back(a * knots[i] + b * knots[i + 1] +
                           ((a * a * a - a) * second[i] + (b * b * b - b) * second[i + 1]) * (h * h / 6.0));
        }
    }
    fine.back() = knots.back();
    return evenArcLength(fine, cells);
}

Polyline reversed(Polyline points)
{
    std::reverse(points.begin(), points.end());
    return points;
}

Polyline joined(Polyline first, const Polyline &second)
{
    DUCTUS_ASSERT((first.back() - second.front()).norm() < 1e-9);
    first.insert(first.end(), second.begin() + 1, second.end());
    return first;
}

Polyline mapped(Polyline points, const std::function<Vec3(const Vec3 &)> &map)
{
    for (Vec3 &point : points)
        point = map(point);
    return points;
}

Polyline drawnOn(const GridPatch &patch, const Polyline &parameters)
{
    return mapped(parameters, [&](const Vec3 &p) { return patch.interpolate(p.x(), p.y()); });
}

Polyline parameterEllipse(double u, double v, double radiusU, double radiusV)
{
    Polyline result;
    constexpr int cells = 48;
    for (int i = 0; i <= cells; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i % cells) / cells;
        result.push_back(Vec3(u + radiusU * std::cos(angle), v + radiusV * std::sin(angle), 0.0));
    }
    return result;
}

Polyline parameterRectangle(double u0, double v0, double u1, double v1)
{
    const Vec3 a(u0, v0, 0), b(u1, v0, 0), c(u1, v1, 0), d(u0, v1, 0);
    return joined(joined(linePoints(a, b, 16), linePoints(b, c, 16)),
                  joined(linePoints(c, d, 16), linePoints(d, a, 16)));
}

} // namespace ductus
