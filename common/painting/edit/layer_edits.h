// Edits of stacks and layers: functions from a painting to the changed one. A refusal (InvalidArgument, or
// Locked for what the painter locked) leaves nothing changed; the remedy says what to do. New ids continue
// from nextId.
#pragma once

#include "painting/scene/painting.h"

namespace ductus {

struct AddedStack
{
    Painting painting;
    StackId stack;
    LayerId substrate;
};

struct AddedLayer
{
    Painting painting;
    LayerId layer;
};

/// A stack with an empty substrate of the same name; \a position 0..number of stacks, others mean the end.
Result<AddedStack> addStack(const Painting &painting, const std::string &name, int position = -1);

/// With all its layers; refused while a layer of another stack is masked by one of them, or one is locked.
Result<Painting> removeStack(const Painting &painting, StackId stack);

/// \a position as counted after the stack has been taken out.
Result<Painting> moveStack(const Painting &painting, StackId stack, int position);

/// And its substrate. Refused for the scene stack.
Result<Painting> renameStack(const Painting &painting, StackId stack, const std::string &name);

/// An empty appearance layer in \a stack (which may be the scene stack); position as for addStack, 0 is
/// lowest.
Result<AddedLayer> addAppearanceLayer(const Painting &painting, StackId stack, const std::string &name,
                                      int position = -1);

/// Refused for substrates (remove the stack), locked layers and layers that mask others.
Result<Painting> removeLayer(const Painting &painting, LayerId layer);

/// Into the same or another stack; \a position as counted after the layer has been taken out. Refused for
/// substrates.
Result<Painting> moveLayer(const Painting &painting, LayerId layer, StackId stack, int position);

/// A copy with all its elements right above it, not locked; only of appearance layers.
Result<AddedLayer> duplicateLayer(const Painting &painting, LayerId layer, const std::string &name);

Result<Painting> renameLayer(const Painting &painting, LayerId layer, const std::string &name);
Result<Painting> setLayerLocked(const Painting &painting, LayerId layer, bool locked);
Result<Painting> setLayerProperties(const Painting &painting, LayerId layer,
                                    const LayerProperties &properties);
Result<Painting> setTolerance(const Painting &painting, LayerId layer, double tolerance, ToleranceMode mode);
Result<Painting> setLayerMotion(const Painting &painting, LayerId layer,
                                const std::vector<PlacementKey> &keys);

} // namespace ductus
