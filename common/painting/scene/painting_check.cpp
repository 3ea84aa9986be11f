#include "painting/scene/painting_check.h"

#include <cmath>
#include <set>

namespace ductus {

namespace {

bool isUnit(double value)
{
    return value >= 0 && value <= 1; // false for NaN
}

bool isColour(const Eigen::Vector3f &colour)
{
    return isUnit(colour[0]) && isUnit(colour[1]) && isUnit(colour[2]);
}

/// Remembers the first broken promise.
class Checker
{
public:
    explicit Checker(const Painting &painting) : mPainting(painting) {}

    Result<void> run()
    {
        require(mPainting.sceneStack.id == sceneStackId && !mPainting.sceneStack.substrate,
                "the scene stack has a wrong id or a substrate");
        for (const Stack &stack : mPainting.stacks) {
            mPlace = stack.name;
            takeId(stack.id.value);
            require(stack.id != sceneStackId, "a stack has the id of the scene stack");
            require(stack.substrate.has_value(), "the stack has no substrate");
            if (stack.substrate)
                checkLayer(*stack.substrate, true);
            for (const Layer &layer : stack.appearance)
                checkLayer(layer, false);
        }
        for (const Layer &layer : mPainting.sceneStack.appearance)
            checkLayer(layer, false);
        checkRest();
        return result();
    }

    Result<void> runLayer(const Layer &layer)
    {
        checkSettings(layer, isSubstrate(mPainting, layer.id));
        return result();
    }

    Result<void> runShape(const ElementShape &shape)
    {
        checkAnyShape(shape);
        return result();
    }

private:
    Result<void> result() const
    {
        if (mProblem.empty())
            return {};
        return Error{ErrorCode::InvalidArgument, "Checking the painting", mProblem, "", mProblemPlace};
    }

    void require(bool holds, const char *problem)
    {
        if (holds || !mProblem.empty())
            return;
        mProblem = problem;
        mProblemPlace = mPlace;
    }

    void takeId(std::int32_t id)
    {
        require(id >= 0 && id < mPainting.nextId, "an id is not below the next one");
        require(mIds.insert(id).second, "an id is used twice");
    }

    void checkLayer(const Layer &layer, bool isSubstrateLayer)
    {
        checkSettings(layer, isSubstrateLayer);
        takeId(layer.id.value);
        for (const Drawing &drawing : layer.drawings)
            for (const Element &element : drawing.elements)
                checkElement(element);
    }

    void checkSettings(const Layer &layer, bool isSubstrateLayer)
    {
        mPlace = layer.name;
        checkProperties(layer.id, layer.properties, isSubstrateLayer);
        require(std::isfinite(layer.tolerance) && layer.tolerance >= 0, "the tolerance is negative");
        require(!layer.drawings.empty() && !layer.frames.drawingOfFrame.empty(), "it has no drawing");
        for (const int drawing : layer.frames.drawingOfFrame)
            require(drawing >= 0 && drawing < int(layer.drawings.size()), "a frame shows no drawing");
        require(layer.frames.framesPerSecond > 0 && std::isfinite(layer.frames.framesPerSecond) &&
                    layer.frames.repeatCount >= 0,
                "its frame rate is of no use");
        checkKeys(layer.motion);
    }

    void checkProperties(LayerId layer, const LayerProperties &properties, bool isSubstrateLayer)
    {
        require(isUnit(properties.opacity), "its opacity is not in 0..1");
        require(!properties.colour || isColour(*properties.colour), "its colour is not in 0..1");
        require(!isSubstrateLayer || (properties.masks.empty() && properties.blendMode == BlendMode::Normal),
                "a substrate has masks or a blend mode");
        for (const Mask &mask : properties.masks)
            std::visit([&](const auto &shape) { checkMask(layer, shape); }, mask.shape);
    }

    void checkMask(LayerId, const GradientMask &mask)
    {
        require(mask.start.allFinite() && mask.end.allFinite() && mask.start != mask.end,
                "a gradient has no extent");
        require(isUnit(mask.opacityAtStart) && isUnit(mask.opacityAtEnd),
                "an opacity of a gradient is not in 0..1");
    }

    void checkMask(LayerId, const NoiseMask &mask)
    {
        require(mask.cellSize > 0 && std::isfinite(mask.cellSize), "a noise has no size");
        require(isUnit(mask.threshold) && isUnit(mask.softness) && isUnit(mask.low) && isUnit(mask.high),
                "a number of a noise is not in 0..1");
    }

    void checkMask(LayerId, const TextureMask &mask)
    {
        require(mask.placement.isValid(), "a texture stands nowhere");
        const auto size = [](int n) { return n > 0 && n <= 4096; };
        require(size(mask.width) && size(mask.height) && size(mask.depth) && mask.values &&
                    mask.values->size() ==
                        std::size_t(mask.width) * std::size_t(mask.height) * std::size_t(mask.depth),
                "a texture has not as many values as cells");
    }

    void checkMask(LayerId layer, const StrokeMask &mask)
    {
        require(mask.layer != layer, "a layer masks itself");
        require(mPainting.findLayer(mask.layer), "a mask names a layer that is not there");
    }

    void checkElement(const Element &element)
    {
        takeId(element.id.value);
        mElements.insert(element.id.value);
        require(element.placement.isValid(), "an element stands nowhere");
        require(element.shape != nullptr, "an element has no shape");
        // A shape that many elements share is looked at once.
        if (element.shape && mShapes.insert(element.shape.get()).second)
            checkAnyShape(*element.shape);
    }

    void checkAnyShape(const ElementShape &any)
    {
        std::visit([&](const auto &shape) { checkShape(shape); }, any);
    }

    void checkShape(const StrokeShape &stroke)
    {
        require(!stroke.points.empty(), "a stroke has no points");
        for (const PaintedPoint &point : stroke.points) {
            require(point.position.allFinite() && point.normal.allFinite(), "a point is not finite");
            require(std::isfinite(point.halfWidth) && point.halfWidth >= 0, "a width is negative");
            require(isColour(point.colour) && isUnit(point.opacity), "a colour is not in 0..1");
        }
    }

    void checkShape(const MeshShape &shape)
    {
        const TriangleMesh &mesh = shape.mesh;
        require(!mesh.isEmpty() && shape.vertexColours.size() == mesh.vertices.size(),
                "a mesh is empty or has not one colour a vertex");
        for (const Vec3 &vertex : mesh.vertices)
            require(vertex.allFinite(), "a vertex is not finite");
        for (const Triangle &triangle : mesh.triangles)
            for (const int vertex : triangle)
                require(vertex >= 0 && vertex < mesh.vertexCount(), "a triangle has no such vertex");
        for (const Eigen::Vector3f &colour : shape.vertexColours)
            require(isColour(colour), "a colour is not in 0..1");
        if (shape.link)
            require(linkProblem(*shape.link).empty(), "a link is not one that can be stored");
    }

    void checkKeys(const std::vector<PlacementKey> &keys)
    {
        for (std::size_t i = 0; i < keys.size(); ++i) {
            require(keys[i].placement.isValid() && std::isfinite(keys[i].timeSeconds),
                    "a key stands nowhere");
            require(i == 0 || keys[i - 1].timeSeconds < keys[i].timeSeconds, "keys are not in order of time");
        }
    }

    void checkRest()
    {
        mPlace = "painting";
        require(isColour(mPainting.background), "the background is not in 0..1");
        require(mPainting.metresPerUnit > 0 && std::isfinite(mPainting.metresPerUnit),
                "the unit has no size");
        require(mPainting.loopSeconds >= 0 && std::isfinite(mPainting.loopSeconds), "the loop has no length");
        for (const Look &look : mPainting.looks)
            checkLook(look);
        for (const MotionGroup &group : mPainting.motionGroups) {
            mPlace = group.name;
            takeId(group.id.value);
            checkKeys(group.keys);
            std::set<ElementId> members;
            for (const ElementId element : group.elements) {
                require(mElements.contains(element.value), "a group moves what is not there");
                require(members.insert(element).second, "a group moves an element twice");
            }
        }
        checkCamera();
        for (const ReferencePicture &picture : mPainting.pictures) {
            mPlace = picture.name;
            takeId(picture.id.value);
            require(picture.image && isUnit(picture.opacity) && picture.placement.isValid(),
                    "a reference picture is incomplete");
        }
    }

    void checkLook(const Look &look)
    {
        mPlace = look.name;
        takeId(look.id.value);
        std::set<LayerId> named;
        for (const auto &[layer, properties] : look.layers) {
            require(mPainting.findLayer(layer), "a look names a layer that is not there");
            require(named.insert(layer).second, "a look names a layer twice");
            checkProperties(layer, properties, isSubstrate(mPainting, layer));
        }
    }

    void checkCamera()
    {
        const std::vector<CameraKey> &keys = mPainting.camera.keys;
        for (std::size_t i = 0; i < keys.size(); ++i) {
            require(keys[i].eye.allFinite() && std::abs(keys[i].rotation.norm() - 1) < 1e-6 &&
                        keys[i].verticalViewDegrees >= 1 && keys[i].verticalViewDegrees <= 170 &&
                        std::isfinite(keys[i].timeSeconds),
                    "a key of the camera stands nowhere");
            require(i == 0 || keys[i - 1].timeSeconds < keys[i].timeSeconds, "keys are not in order of time");
        }
    }

    const Painting &mPainting;
    std::string mPlace;
    std::string mProblem;
    std::string mProblemPlace;
    std::set<std::int32_t> mIds;
    std::set<std::int32_t> mElements;
    std::set<const ElementShape *> mShapes;
};

} // namespace

Result<void> checkPainting(const Painting &painting)
{
    return Checker(painting).run();
}

Result<void> checkLayer(const Painting &painting, const Layer &layer)
{
    return Checker(painting).runLayer(layer);
}

Result<void> checkShape(const ElementShape &shape)
{
    static const Painting none;
    return Checker(none).runShape(shape);
}

} // namespace ductus
