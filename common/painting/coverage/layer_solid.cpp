#include "painting/coverage/layer_solid.h"

#include "painting/coverage/stroke_segments.h"

#include <algorithm>

namespace ductus {

namespace {

Coating coatingOf(const SegmentData &segment, const Vec3 &x)
{
    const float t = float(segmentParameter(segment, x));
    const Eigen::Vector3f mixed = (1 - t) * segment.colourA + t * segment.colourB;
    return {int(segment.element), mixed.cwiseMax(0).cwiseMin(1), // rounding
            std::clamp(double((1 - t) * segment.opacityA + t * segment.opacityB), 0.0, 1.0)};
}

} // namespace

LayerSolid::LayerSolid(const Layer &layer, const LayerProperties &properties,
                       const ElementPlacements &placements)
    : mLayer(&layer), mProperties(&properties), mDrawing(&layer.drawingAt(placements.timeSeconds())),
      mTolerance(layer.tolerance)
{
    for (std::size_t i = 0; i < mDrawing->elements.size(); ++i) {
        const Element &element = mDrawing->elements[i];
        const Eigen::Affine3d place = placements.sceneFromElement(layer, element).matrix();
        if (const auto *stroke = std::get_if<StrokeShape>(element.shape.get()))
            appendStrokeSegments(*stroke, place, std::uint32_t(i), properties.colour, mSegments);
        else
            mMeshes.push_back({MeshSolid(std::get<MeshShape>(*element.shape), place), int(i)});
    }
    std::vector<Box3> boxes;
    const auto addBox = [&](const Box3 &box) {
        mBox.add(box.min);
        mBox.add(box.max);
    };
    for (const SegmentData &segment : mSegments) {
        addBox(segmentBounds(segment).box());
        boxes.push_back(segmentBounds(segment, mTolerance).box());
    }
    for (const MeshElement &mesh : mMeshes) {
        addBox(mesh.solid.box());
        Box3 box = mesh.solid.box();
        box.min.array() -= mTolerance;
        box.max.array() += mTolerance;
        boxes.push_back(box);
    }
    mTree = BoxTree(boxes);
}

std::optional<SkinHit> LayerSolid::hit(const Vec3 &origin, const Vec3 &direction, double from, double limit,
                                       const std::vector<int> &seen) const
{
    const auto isSeen = [&](int element) { return std::binary_search(seen.begin(), seen.end(), element); };
    std::optional<SkinHit> nearest;
    int segmentHit = -1;
    mTree.forRay(origin, direction, limit, [&](int thing) {
        if (thing < int(mSegments.size())) {
            const SegmentData &segment = mSegments[std::size_t(thing)];
            if (isSeen(int(segment.element)))
                return limit;
            const auto s = segmentSurface(segment, origin, direction, from);
            // At equal distance the first one stands, in whatever order the tree comes by.
            if (s && (*s < limit || (*s == limit && thing < segmentHit))) {
                limit = *s;
                segmentHit = thing;
                nearest = SkinHit{*s, int(segment.element), segment.colourA, 1};
            }
            return limit;
        }
        const MeshElement &mesh = mMeshes[std::size_t(thing) - mSegments.size()];
        if (isSeen(mesh.element))
            return limit;
        if (const auto hit = mesh.solid.hit(origin, direction, from, limit)) {
            limit = hit->s;
            segmentHit = -1;
            nearest = SkinHit{hit->s, mesh.element,
                              mProperties->colour ? *mProperties->colour : mesh.solid.colour(*hit), 1};
        }
        return limit;
    });
    if (nearest && segmentHit >= 0) {
        const Coating coating =
            coatingOf(mSegments[std::size_t(segmentHit)], origin + nearest->s * direction);
        nearest->colour = coating.colour;
        nearest->opacity = coating.opacity;
    }
    return nearest;
}

std::optional<SegmentDistance> LayerSolid::distance(const Vec3 &x, double limit) const
{
    std::optional<SegmentDistance> outside, inside;
    mTree.forNear(x, limit, [&](int thing) {
        SegmentDistance found;
        if (thing < int(mSegments.size())) {
            found = segmentDistance(mSegments[std::size_t(thing)], x);
        } else {
            const MeshSolid &mesh = mMeshes[std::size_t(thing) - mSegments.size()].solid;
            const auto hit = mesh.nearest(x, limit);
            if (!hit)
                return limit;
            const Vec3 from = x - mesh.point(*hit);
            found = {hit->s, hit->s > 1e-9 * mesh.box().diagonal() ? Vec3(from / hit->s)
                                                                   : mesh.normal(hit->triangle)};
        }
        if (found.distance <= 0) {
            if (!inside || found.distance < inside->distance)
                inside = found;
            limit = std::min(limit, 0.0);
        } else if (found.distance <= limit && (!outside || found.distance < outside->distance)) {
            outside = found;
            limit = found.distance;
        }
        return limit;
    });
    return inside ? inside : outside;
}

bool LayerSolid::reaches(const SegmentData &segment, const Vec3 &x, const Vec3 *view) const
{
    if (view && mLayer->toleranceMode == ToleranceMode::View) {
        if (segmentContains(segment, x))
            return true;
        const auto along = mTolerance > 0 ? segmentInterval(segment, x, *view) : std::nullopt;
        return along && along->first <= mTolerance && along->second >= -mTolerance;
    }
    return segmentReaches(segment, x, mTolerance);
}

bool LayerSolid::reaches(const MeshSolid &mesh, const Vec3 &x, const Vec3 *view) const
{
    if (mTolerance > 0) {
        if (view && mLayer->toleranceMode == ToleranceMode::View) {
            if (mesh.hit(x - mTolerance * *view, *view, 0, 2 * mTolerance))
                return true;
        } else if (mesh.nearest(x, mTolerance)) {
            return true;
        }
    }
    return mesh.contains(x);
}

Box3 LayerSolid::queryBox(const Vec3 &x, const Vec3 *view) const
{
    Box3 box;
    box.add(x);
    if (view && mLayer->toleranceMode == ToleranceMode::View) {
        box.add(x + mTolerance * *view);
        box.add(x - mTolerance * *view);
    }
    return box;
}

void LayerSolid::coatings(const Vec3 &x, const Vec3 *view, std::vector<Coating> &found) const
{
    found.clear();
    std::vector<std::pair<int, int>> covering; // element, thing
    mTree.forBox(queryBox(x, view), [&](int thing) {
        if (thing < int(mSegments.size())) {
            const SegmentData &segment = mSegments[std::size_t(thing)];
            if (reaches(segment, x, view))
                covering.emplace_back(int(segment.element), thing);
        } else {
            const MeshElement &mesh = mMeshes[std::size_t(thing) - mSegments.size()];
            if (reaches(mesh.solid, x, view))
                covering.emplace_back(mesh.element, thing);
        }
    });
    std::sort(covering.begin(), covering.end());
    for (std::size_t i = 0; i < covering.size(); ++i) {
        const auto [element, thing] = covering[i];
        if (i > 0 && covering[i - 1].first == element)
            continue; // a stroke colours a point once
        if (thing < int(mSegments.size()))
            found.push_back(coatingOf(mSegments[std::size_t(thing)], x));
        else
            found.push_back({element,
                             mProperties->colour.value_or(
                                 mMeshes[std::size_t(thing) - mSegments.size()].solid.meanColour()),
                             1});
    }
}

bool LayerSolid::covers(const Vec3 &x, const Vec3 *view) const
{
    bool covered = false;
    mTree.forBox(queryBox(x, view), [&](int thing) {
        if (covered)
            return;
        covered = thing < int(mSegments.size())
                      ? reaches(mSegments[std::size_t(thing)], x, view)
                      : reaches(mMeshes[std::size_t(thing) - mSegments.size()].solid, x, view);
    });
    return covered;
}

} // namespace ductus
