#include "sketchsurfacer/ui/presentation/found_borders.h"

#include "geometry/point_tree.h"

#include <unordered_set>

namespace ductus {

namespace {

constexpr double nearImage = 0.015; // of the box diagonal: as far as a hand draws a mirror image astray

// Whether nearly all of a stroke lies where the mirror shows the border.
bool isImage(const Stroke &stroke, const SurfacingState &state, const PointTree &border)
{
    const SymmetryPlane &plane = *state.sketch->plane;
    std::size_t near = 0;
    for (const Vec3 &p : stroke.points) {
        const Vec3 at = state.sketch->frame.unitFromInput(p);
        if (plane.signedDistance(at) > nearImage)
            return false; // of the solved half, where the solver has decided
        const Vec3 image = at - 2.0 * plane.signedDistance(at) * plane.normal;
        const std::vector<int> nearest = border.nearest(image, 1);
        near +=
            !nearest.empty() && (border.points()[std::size_t(nearest.front())] - image).norm() < nearImage;
    }
    return !stroke.points.empty() && 10 * near >= 9 * stroke.points.size();
}

} // namespace

std::vector<StrokeId> foundBorders(const StrokeSet &strokes, const SurfacingState &state)
{
    std::vector<StrokeId> found;
    if (!state.proxy || !state.sketch || state.proxy->borderStrokes.strokes.empty())
        return found;
    const StrokeSet &borders = state.proxy->borderStrokes;
    std::unordered_set<int> ids;
    for (const Stroke &stroke : borders.strokes)
        ids.insert(stroke.id.value);
    std::optional<PointTree> tree;
    if (state.sketch->plane)
        tree.emplace(borders.allPoints());
    for (const Stroke &stroke : strokes.strokes)
        if (stroke.role == StrokeRole::Surface &&
            (ids.count(stroke.id.value) > 0 || (tree && isImage(stroke, state, *tree))))
            found.push_back(stroke.id);
    return found;
}

} // namespace ductus
