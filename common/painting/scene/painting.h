// Painting: an ordered list of stacks, each a substrate with appearance layers above it, and a scene stack
// whose layers colour all substrates after every other stack. A value: copies share the strokes. painting.md
// section 1.
#pragma once

#include "base/result.h"
#include "imaging/image.h"
#include "painting/scene/layer.h"

namespace ductus {

/// The scene stack's id; others are larger.
inline constexpr StackId sceneStackId{0};

struct Stack
{
    StackId id;
    std::string name;
    std::optional<Layer> substrate; // only the scene stack has none
    std::vector<Layer> appearance;  // bottom to top
};

/// Layer properties under a name: "day", "night" (Fig. V.10). Layers it does not name keep theirs.
struct Look
{
    LookId id;
    std::string name;
    std::vector<std::pair<LayerId, LayerProperties>> layers; // each layer once
};

/// A picture in space to paint from; never exported.
struct ReferencePicture
{
    PictureId id;
    std::string name;
    bool visible = true;
    double opacity = 1;                 // 0..1
    Placement placement;                // scene from a plane one unit high around its middle
    std::shared_ptr<const Image> image; // never null
};

struct Painting
{
    std::vector<Stack> stacks; // in drawing order
    Stack sceneStack{sceneStackId, "Scene", std::nullopt, {}};
    BlendSpace blendSpace = BlendSpace::Encoded;
    Eigen::Vector3f background = Eigen::Vector3f::Ones(); // linear RGB, 0..1
    double metresPerUnit = 1;                             // > 0
    std::vector<Look> looks;
    std::vector<MotionGroup> motionGroups;
    CameraPath camera;
    double loopSeconds = 0; // 0: no loop
    std::vector<ReferencePicture> pictures;
    std::int32_t nextId = 1; // larger than every id in use

    /// Null if there is none; the scene stack too.
    const Stack *findStack(StackId id) const;
    const Layer *findLayer(LayerId id) const;
    const Look *findLook(LookId id) const;
    /// The stack a layer stands in, null for none.
    const Stack *stackOf(LayerId id) const;
    /// All layers: stacks in order, substrate first; then the scene stack's.
    std::vector<const Layer *> layers() const;

    // For edits.
    Stack *findStack(StackId id);
    Layer *findLayer(LayerId id);
};

/// True for layers that are a stack's substrate.
bool isSubstrate(const Painting &painting, LayerId layer);

} // namespace ductus
