// A layer at one time, in the scene: its strokes as segments, its meshes, and a tree to find them by.
#pragma once

#include "painting/coverage/mesh_solid.h"
#include "painting/coverage/section.h"
#include "painting/coverage/segment_distance.h"
#include "painting/scene/element_placement.h"

namespace ductus {

/// A place of the skin that a ray meets.
struct SkinHit
{
    double s = 0;
    int element = -1;                                 // place in the drawing
    Eigen::Vector3f colour = Eigen::Vector3f::Zero(); // linear RGB
    double opacity = 1;                               // the stroke's own there
};

/// An element that colours a point.
struct Coating
{
    int element = -1;                                 // place in the drawing
    Eigen::Vector3f colour = Eigen::Vector3f::Zero(); // linear RGB
    double opacity = 1;
};

class LayerSolid
{
public:
    struct MeshElement
    {
        MeshSolid solid;
        int element;
    };

    /// \a properties may be those of a look. The layer must outlive the object.
    LayerSolid(const Layer &layer, const LayerProperties &properties, const ElementPlacements &placements);

    const Layer &layer() const { return *mLayer; }
    const LayerProperties &properties() const { return *mProperties; }
    const Element &element(int index) const { return mDrawing->elements[std::size_t(index)]; }
    const Box3 &box() const { return mBox; } // of the skin
    const std::vector<SegmentData> &segments() const { return mSegments; }

    const std::vector<MeshElement> &meshes() const { return mMeshes; }

    /// For reach.h.
    std::vector<SegmentData> &segments() { return mSegments; }

    /// The nearest skin at from <= s < limit of elements that are not in \a seen (sorted).
    std::optional<SkinHit> hit(const Vec3 &origin, const Vec3 &direction, double from, double limit,
                               const std::vector<int> &seen) const;

    /// Where the skin is nearest to \a x within \a limit: for points inside, that of the element in which
    /// they are deepest.
    std::optional<SegmentDistance> distance(const Vec3 &x, double limit) const;

    /// The elements that cover \a x, in drawing order, each once: inside or within the layer's tolerance
    /// (painting.md section 2, rule 1). Of a stroke the first segment along it that covers x gives the
    /// colour. \a view is the direction of the view, as long as depth grows by 1; without one, layers of
    /// ToleranceMode::View are taken as Surface. Meshes colour what they wind around or what is no further
    /// than the tolerance from a triangle, in their mean colour.
    void coatings(const Vec3 &x, const Vec3 *view, std::vector<Coating> &found) const;

    /// Whether any element covers \a x.
    bool covers(const Vec3 &x, const Vec3 *view) const;

private:
    bool reaches(const SegmentData &segment, const Vec3 &x, const Vec3 *view) const;
    bool reaches(const MeshSolid &mesh, const Vec3 &x, const Vec3 *view) const;
    Box3 queryBox(const Vec3 &x, const Vec3 *view) const;

    const Layer *mLayer;
    const LayerProperties *mProperties;
    const Drawing *mDrawing;
    double mTolerance;
    std::vector<SegmentData> mSegments; // ordered by element, along the stroke
    std::vector<MeshElement> mMeshes;
    Box3 mBox;
    BoxTree mTree; // of the boxes of what segments reach, then meshes
};

} // namespace ductus
