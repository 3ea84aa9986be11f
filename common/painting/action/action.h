// Actions: everything a painter can do to a painting, as values. A document performs them, the action log
// keeps them, a script is a list of them (painting.md section 5). Each names the objects it is about and its
// parameters; what the words mean is described in resources/manual/layerpainter-actions.md.
#pragma once

#include "painting/scene/painting.h"

#include <utility>

namespace ductus::act {

// Every action lists its fields once, for writing and reading alike.

struct AddStack
{
    static constexpr std::string_view word = "addStack";
    std::string name;
    int position = -1; // -1: the end
    template <typename F>
    void fields(F &f)
    {
        f.parameter("name", name);
        f.parameter("position", position);
    }
};

struct RemoveStack
{
    static constexpr std::string_view word = "removeStack";
    StackId stack;
    template <typename F>
    void fields(F &f)
    {
        f.object("stack", stack);
    }
};

struct MoveStack
{
    static constexpr std::string_view word = "moveStack";
    StackId stack;
    int position = -1;
    template <typename F>
    void fields(F &f)
    {
        f.object("stack", stack);
        f.parameter("position", position);
    }
};

struct RenameStack
{
    static constexpr std::string_view word = "renameStack";
    StackId stack;
    std::string name;
    template <typename F>
    void fields(F &f)
    {
        f.object("stack", stack);
        f.parameter("name", name);
    }
};

struct AddLayer
{
    static constexpr std::string_view word = "addLayer";
    StackId stack;
    std::string name;
    int position = -1;
    template <typename F>
    void fields(F &f)
    {
        f.object("stack", stack);
        f.parameter("name", name);
        f.parameter("position", position);
    }
};

struct RemoveLayer
{
    static constexpr std::string_view word = "removeLayer";
    LayerId layer;
    template <typename F>
    void fields(F &f)
    {
        f.object("layer", layer);
    }
};

struct MoveLayer
{
    static constexpr std::string_view word = "moveLayer";
    LayerId layer;
    StackId stack;
    int position = -1;
    template <typename F>
    void fields(F &f)
    {
        f.object("layer", layer);
        f.object("stack", stack);
        f.parameter("position", position);
    }
};

/// With all strokes, right above the original; only appearance layers.
struct DuplicateLayer
{
    static constexpr std::string_view word = "duplicateLayer";
    LayerId layer;
    std::string name;
    template <typename F>
    void fields(F &f)
    {
        f.object("layer", layer);
        f.parameter("name", name);
    }
};

struct RenameLayer
{
    static constexpr std::string_view word = "renameLayer";
    LayerId layer;
    std::string name;
    template <typename F>
    void fields(F &f)
    {
        f.object("layer", layer);
        f.parameter("name", name);
    }
};

struct LockLayer
{
    static constexpr std::string_view word = "lockLayer";
    LayerId layer;
    bool locked = true;
    template <typename F>
    void fields(F &f)
    {
        f.object("layer", layer);
        f.parameter("locked", locked);
    }
};

/// What a look stores; only what is given changes.
struct SetProperties
{
    static constexpr std::string_view word = "setProperties";
    LayerId layer;
    std::optional<bool> visible;
    std::optional<double> opacity;
    std::optional<BlendMode> blend;
    std::optional<Eigen::Vector3f> colour; // for all strokes instead of their own
    std::optional<bool> ownColours;        // true: the strokes' own again
    std::optional<std::vector<Mask>> masks;
    template <typename F>
    void fields(F &f)
    {
        f.object("layer", layer);
        f.parameter("visible", visible);
        f.parameter("opacity", opacity);
        f.parameter("blend", blend);
        f.parameter("colour", colour);
        f.parameter("ownColours", ownColours);
        f.parameter("masks", masks);
    }
};

struct SetTolerance
{
    static constexpr std::string_view word = "setTolerance";
    LayerId layer;
    double tolerance = 0;
    ToleranceMode mode = ToleranceMode::Surface;
    template <typename F>
    void fields(F &f)
    {
        f.object("layer", layer);
        f.parameter("tolerance", tolerance);
        f.parameter("mode", mode);
    }
};

struct SetLayerMotion
{
    static constexpr std::string_view word = "setLayerMotion";
    LayerId layer;
    std::vector<PlacementKey> keys;
    template <typename F>
    void fields(F &f)
    {
        f.object("layer", layer);
        f.parameter("keys", keys);
    }
};

/// Adds strokes at the end of a layer's drawing.
struct Draw
{
    static constexpr std::string_view word = "draw";
    LayerId layer;
    int drawing = 0;
    Placement placement; // of all of them
    std::vector<std::shared_ptr<const ElementShape>> strokes;
    template <typename F>
    void fields(F &f)
    {
        f.object("layer", layer);
        f.parameter("drawing", drawing);
        f.parameter("placement", placement);
        f.parameter("strokes", strokes);
    }
};

struct Erase
{
    static constexpr std::string_view word = "erase";
    std::vector<ElementId> elements;
    template <typename F>
    void fields(F &f)
    {
        f.object("elements", elements);
    }
};

/// Keeps only parts of a stroke: each from a place along it to another, counted in points (1.5 is half way
/// between the second and the third). The parts stand where the stroke stood.
struct Cut
{
    static constexpr std::string_view word = "cut";
    ElementId element;
    std::vector<std::pair<double, double>> kept;
    template <typename F>
    void fields(F &f)
    {
        f.object("element", element);
        f.parameter("kept", kept);
    }
};

struct MoveElements
{
    static constexpr std::string_view word = "moveElements";
    std::vector<ElementId> elements;
    LayerId layer;
    int drawing = 0;
    template <typename F>
    void fields(F &f)
    {
        f.object("elements", elements);
        f.object("layer", layer);
        f.parameter("drawing", drawing);
    }
};

/// Copies into a layer, moved by \a change: how highlights and shadows are made (V.4.1).
struct Duplicate
{
    static constexpr std::string_view word = "duplicate";
    std::vector<ElementId> elements;
    LayerId layer;
    int drawing = 0;
    Placement change;
    template <typename F>
    void fields(F &f)
    {
        f.object("elements", elements);
        f.object("layer", layer);
        f.parameter("drawing", drawing);
        f.parameter("change", change);
    }
};

struct Transform
{
    static constexpr std::string_view word = "transform";
    std::vector<ElementId> elements;
    Placement change; // after each element's own
    template <typename F>
    void fields(F &f)
    {
        f.object("elements", elements);
        f.parameter("change", change);
    }
};

struct Recolour
{
    static constexpr std::string_view word = "recolour";
    std::vector<ElementId> elements;
    Eigen::Vector3f colour = Eigen::Vector3f::Zero();
    template <typename F>
    void fields(F &f)
    {
        f.object("elements", elements);
        f.parameter("colour", colour);
    }
};

/// Other shapes for elements that stay where they are: what they were made from has changed.
struct ReplaceShape
{
    static constexpr std::string_view word = "replaceShape";
    std::vector<ElementId> elements;
    std::vector<std::shared_ptr<const ElementShape>> strokes; // one for all, or one each
    template <typename F>
    void fields(F &f)
    {
        f.object("elements", elements);
        f.parameter("strokes", strokes);
    }
};

struct AddLook
{
    static constexpr std::string_view word = "addLook";
    std::string name;
    template <typename F>
    void fields(F &f)
    {
        f.parameter("name", name);
    }
};

struct UpdateLook
{
    static constexpr std::string_view word = "updateLook";
    LookId look;
    template <typename F>
    void fields(F &f)
    {
        f.object("look", look);
    }
};

struct ApplyLook
{
    static constexpr std::string_view word = "applyLook";
    LookId look;
    template <typename F>
    void fields(F &f)
    {
        f.object("look", look);
    }
};

struct RenameLook
{
    static constexpr std::string_view word = "renameLook";
    LookId look;
    std::string name;
    template <typename F>
    void fields(F &f)
    {
        f.object("look", look);
        f.parameter("name", name);
    }
};

struct RemoveLook
{
    static constexpr std::string_view word = "removeLook";
    LookId look;
    template <typename F>
    void fields(F &f)
    {
        f.object("look", look);
    }
};

/// Of the whole painting; only what is given changes.
struct SetScene
{
    static constexpr std::string_view word = "setScene";
    std::optional<Eigen::Vector3f> background;
    std::optional<BlendSpace> blendSpace;
    std::optional<double> loopSeconds;
    template <typename F>
    void fields(F &f)
    {
        f.parameter("background", background);
        f.parameter("blendSpace", blendSpace);
        f.parameter("loopSeconds", loopSeconds);
    }
};

struct SetCamera
{
    static constexpr std::string_view word = "setCamera";
    std::vector<CameraKey> keys;
    template <typename F>
    void fields(F &f)
    {
        f.parameter("keys", keys);
    }
};

/// Elements that move as one (Fig. V.9).
struct AddGroup
{
    static constexpr std::string_view word = "addGroup";
    std::vector<ElementId> elements;
    std::string name;
    std::vector<PlacementKey> keys;
    template <typename F>
    void fields(F &f)
    {
        f.object("elements", elements);
        f.parameter("name", name);
        f.parameter("keys", keys);
    }
};

struct SetGroupMotion
{
    static constexpr std::string_view word = "setGroupMotion";
    MotionGroupId group;
    std::vector<PlacementKey> keys;
    template <typename F>
    void fields(F &f)
    {
        f.object("group", group);
        f.parameter("keys", keys);
    }
};

struct RemoveGroup
{
    static constexpr std::string_view word = "removeGroup";
    MotionGroupId group;
    template <typename F>
    void fields(F &f)
    {
        f.object("group", group);
    }
};

} // namespace ductus::act

namespace ductus {

using PaintingAction =
    std::variant<act::AddStack, act::RemoveStack, act::MoveStack, act::RenameStack, act::AddLayer,
                 act::RemoveLayer, act::MoveLayer, act::DuplicateLayer, act::RenameLayer, act::LockLayer,
                 act::SetProperties, act::SetTolerance, act::SetLayerMotion, act::Draw, act::Erase, act::Cut,
                 act::MoveElements, act::Duplicate, act::Transform, act::Recolour, act::ReplaceShape,
                 act::AddLook, act::UpdateLook, act::ApplyLook, act::RenameLook, act::RemoveLook,
                 act::SetScene, act::SetCamera, act::AddGroup, act::SetGroupMotion, act::RemoveGroup>;

/// "addStack"
std::string_view actionWord(const PaintingAction &action);

struct PerformedAction
{
    Painting painting;
    std::vector<std::int32_t> made; // ids of what is new: a stack and its substrate, strokes in their order
};

/// What \a action makes of \a painting, or why it is refused; the same painting and action give the same
/// result and the same ids.
Result<PerformedAction> performed(const Painting &painting, const PaintingAction &action);

} // namespace ductus
