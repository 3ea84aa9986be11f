// A painting at one time and in one look, ready to be asked: what does a ray meet, what colour has a point,
// which layers colour it. The definition of painting.md section 2 for single points.
#pragma once

#include "base/job_control.h"
#include "painting/blend/blend.h"
#include "painting/coverage/layer_solid.h"

#include <map>
#include <memory>

namespace ductus {

struct PaintingMoment
{
    double timeSeconds = 0;     // looped as the painting says
    std::optional<LookId> look; // none: as the layers are
};

/// A visible point of a substrate.
struct SubstratePoint
{
    Vec3 position = Vec3::Zero();
    double depth = 0; // along the ray
    int stack = -1;   // place in Painting::stacks
    StackId stackId;
    ElementId element;
    Eigen::Vector3f colour = Eigen::Vector3f::Zero(); // its own, linear RGB
    double opacity = 1;                               // the stroke's times the layer's
};

/// What one layer does to a point.
struct LayerColouring
{
    LayerId layer;
    std::vector<ElementId> elements; // that cover the point, in drawing order
    PremultipliedColour source;      // of its strokes, in the blend space
    double opacity = 1;              // the layer's times its masks'
    Eigen::Vector3d result;          // the point's colour with this layer and all below, in the blend space
};

/// What lies behind how many translucent substrate elements is not drawn.
inline constexpr int mostSurfaces = 8;

class PaintingSolid
{
public:
    /// InvalidArgument for a look that is not there; Cancelled.
    static Result<PaintingSolid> make(const Painting &painting, const PaintingMoment &moment,
                                      const JobControl &control);

    const Painting &painting() const { return *mPainting; }

    /// What a ray meets, from near to far. Every substrate element shows its first skin only (so that a
    /// translucent stroke is as strong where its back or another part of it lies behind); the list ends with
    /// the first opaque point, or after mostSurfaces. Hidden substrates and such without opacity are not
    /// there.
    void surfaces(const Vec3 &origin, const Vec3 &direction, double from,
                  std::vector<SubstratePoint> &points) const;

    /// The opaque colour of a point in the blend space: its own, then the visible appearance layers of its
    /// stack bottom to top, then those of the scene stack. \a view as LayerSolid::coatings.
    Eigen::Vector3d colour(const SubstratePoint &point, const Vec3 *view) const;

    /// The layers that colour a point, TOP TO BOTTOM; those that leave it as it is are left out.
    std::vector<LayerColouring> coloursAt(const SubstratePoint &point, const Vec3 *view) const;

    /// Visible substrates by stack; null for hidden ones.
    const LayerSolid *substrate(std::size_t stack) const { return mStacks[stack].substrate; }
    std::size_t stackCount() const { return mStacks.size(); }

private:
    struct StackSolid
    {
        const LayerSolid *substrate = nullptr;
        std::vector<const LayerSolid *> appearance; // visible ones, bottom to top
    };

    PaintingSolid() = default;
    LayerSolid *solidOf(const Layer &layer, const ElementPlacements &placements);
    void addStack(const Stack &stack, const ElementPlacements &placements);
    void addMaskLayers(const ElementPlacements &placements);
    void addReaches(const JobControl &control);
    LayerColouring colouring(const LayerSolid &layer, const Eigen::Vector3d &backdrop, const Vec3 &x,
                             const Vec3 *view, std::vector<Coating> &coatings) const;

    std::shared_ptr<const Painting> mPainting; // the solids point into it
    std::map<LayerId, std::unique_ptr<LayerSolid>> mSolids;
    std::vector<StackSolid> mStacks; // as Painting::stacks
    StackSolid mScene;
    BoxTree mStackTree;
};

} // namespace ductus
