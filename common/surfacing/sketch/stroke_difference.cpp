#include "surfacing/sketch/stroke_difference.h"

#include <algorithm>

namespace ductus {

namespace {

bool carriesSurface(const Stroke &stroke)
{
    return stroke.role == StrokeRole::Surface || stroke.role == StrokeRole::Boundary;
}

bool comesFirst(const Stroke *a, const Stroke *b)
{
    if (a->role != b->role)
        return a->role < b->role;
    return std::lexicographical_compare(a->points.begin(), a->points.end(), b->points.begin(),
                                        b->points.end(), [](const Vec3 &p, const Vec3 &q) {
                                            return std::lexicographical_compare(p.data(), p.data() + 3,
                                                                                q.data(), q.data() + 3);
                                        });
}

std::vector<const Stroke *> sorted(const StrokeSet &set)
{
    std::vector<const Stroke *> result;
    for (const Stroke &stroke : set.strokes)
        if (carriesSurface(stroke))
            result.push_back(&stroke);
    std::stable_sort(result.begin(), result.end(), comesFirst);
    return result;
}

// Those of \a a without a partner in \a b, in the order of their sketch.
std::vector<Stroke> without(const std::vector<const Stroke *> &a, const std::vector<const Stroke *> &b)
{
    std::vector<const Stroke *> rest;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(rest), comesFirst);
    std::sort(rest.begin(), rest.end()); // both point into one array
    std::vector<Stroke> result;
    for (const Stroke *stroke : rest)
        result.push_back(*stroke);
    return result;
}

} // namespace

double StrokeDifference::length() const
{
    double longest = 0.0;
    for (const std::vector<Stroke> *strokes : {&removed, &added}) {
        double sum = 0.0;
        for (const Stroke &stroke : *strokes)
            sum += polylineLength(stroke.points);
        longest = std::max(longest, sum);
    }
    return longest;
}

bool StrokeDifference::hasBoundaryStrokes() const
{
    const auto isBoundary = [](const Stroke &stroke) { return stroke.role == StrokeRole::Boundary; };
    return std::any_of(removed.begin(), removed.end(), isBoundary) ||
           std::any_of(added.begin(), added.end(), isBoundary);
}

StrokeDifference differenceBetween(const StrokeSet &before, const StrokeSet &after)
{
    const std::vector<const Stroke *> a = sorted(before), b = sorted(after);
    return {without(a, b), without(b, a)};
}

} // namespace ductus
