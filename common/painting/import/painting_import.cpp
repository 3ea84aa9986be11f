#include "painting/import/painting_import.h"

#include "painting/scene/painting_check.h"

#include <map>

namespace ductus {

namespace {

StrokeSection sectionOf(PaintingFileSection section)
{
    switch (section) {
    case PaintingFileSection::Ribbon:
        return StrokeSection::Ribbon;
    case PaintingFileSection::Ellipse:
        return StrokeSection::Ellipse;
    case PaintingFileSection::Cube:
        return StrokeSection::Cube;
    case PaintingFileSection::Round:
        break;
    }
    return StrokeSection::Round;
}

using ShapePointer = std::shared_ptr<const ElementShape>;

ShapePointer shapeOf(const PaintingFileStroke &stroke)
{
    StrokeShape shape;
    shape.section = sectionOf(stroke.section);
    shape.points.reserve(stroke.points.size());
    for (const PaintingFilePoint &point : stroke.points)
        shape.points.push_back({point.position, point.normal, point.halfWidth, point.colour, point.opacity});
    return std::make_shared<const ElementShape>(std::move(shape));
}

class Importing
{
public:
    explicit Importing(const PaintingFile &file) : mFile(file) {}

    Result<ImportedPainting> run()
    {
        Painting &painting = mImported.painting;
        painting.metresPerUnit = mFile.metresPerUnit;
        if (mFile.background)
            painting.background = *mFile.background;
        for (int l = 0; l < int(mFile.layers.size()); ++l) {
            const PaintingFileLayer &layer = mFile.layers[std::size_t(l)];
            const PaintingFileAnimation &animation = layer.animation;
            if (animation.transform.size() > 1 || animation.opacity.size() > 1 ||
                animation.visibility.size() > 1)
                note(l, "its animation keys are not imported");
            if (layer.kind == PaintingFileLayerKind::Paint && !layer.drawings.empty())
                addLayer(l);
            else if (layer.picture)
                addPicture(l);
        }
        tellApart();
        if (const Result<void> check = checkPainting(painting); !check) {
            Error error = check.error();
            error.attempted = "Importing the painting";
            error.remedy = "Put right the transform of that layer in the program it comes from";
            return error;
        }
        return std::move(mImported);
    }

private:
    void note(int layer, const std::string &text)
    {
        mImported.notes.push_back(mFile.pathOf(layer) + ": " + text);
    }

    template <typename Id>
    Id takeId()
    {
        return Id{mImported.painting.nextId++};
    }

    /// Stacks are a flat list: of those with the same name each is told by the group it was in.
    void tellApart()
    {
        std::map<std::string, int> uses;
        for (const Stack &stack : mImported.painting.stacks)
            ++uses[stack.name];
        for (std::size_t i = 0; i < mStackLayers.size(); ++i) {
            Stack &stack = mImported.painting.stacks[i];
            const int group = mFile.layers[std::size_t(mStackLayers[i])].parent;
            if (uses[stack.name] < 2 || group <= 0) // the root says nothing
                continue;
            stack.name = mFile.layers[std::size_t(group)].name + " / " + stack.name;
            stack.substrate->name = stack.name;
        }
    }

    /// Times that of all groups around it.
    double opacityOf(int layer) const
    {
        double opacity = 1;
        for (; layer >= 0; layer = mFile.layers[std::size_t(layer)].parent)
            opacity *= mFile.layers[std::size_t(layer)].opacity;
        return opacity;
    }

    void addLayer(int index)
    {
        const PaintingFileLayer &source = mFile.layers[std::size_t(index)];
        Stack stack;
        stack.id = takeId<StackId>();
        stack.name = source.name;
        Layer &layer = stack.substrate.emplace();
        layer.id = takeId<LayerId>();
        layer.name = source.name;
        layer.locked = source.locked;
        layer.properties.visible = mFile.isShown(index);
        layer.properties.opacity = opacityOf(index);
        layer.frames.framesPerSecond = source.framesPerSecond;
        layer.frames.repeatCount = source.frameRepeatCount;
        layer.frames.drawingOfFrame = source.frames;
        layer.drawings.clear();
        const Placement placement = placementOf(mFile.sceneFromLayer(index));
        int fading = 0, empty = 0;
        for (const auto &drawing : source.drawings) {
            Drawing &target = layer.drawings.emplace_back();
            for (const PaintingFileStroke &stroke : drawing->strokes) {
                if (stroke.points.empty()) {
                    ++empty;
                    continue;
                }
                fading += stroke.fadesSeenFromAside;
                ShapePointer &shape = mShapes[&stroke]; // drawings that layers share stay shared
                if (!shape)
                    shape = shapeOf(stroke);
                target.elements.push_back({takeId<ElementId>(), placement, shape});
            }
        }
        if (empty > 0)
            note(index, std::to_string(empty) + " strokes without points were left out");
        if (fading > 0)
            note(index,
                 std::to_string(fading) + " strokes fade when seen from aside in Quill, here they do not");
        mImported.painting.stacks.push_back(std::move(stack));
        mStackLayers.push_back(index);
    }

    void addPicture(int index)
    {
        const PaintingFileLayer &source = mFile.layers[std::size_t(index)];
        mImported.painting.pictures.push_back({takeId<PictureId>(), source.name, mFile.isShown(index),
                                               opacityOf(index), placementOf(mFile.sceneFromLayer(index)),
                                               std::make_shared<const Image>(*source.picture)});
    }

    const PaintingFile &mFile;
    ImportedPainting mImported;
    std::vector<int> mStackLayers; // of the file, one a stack
    std::map<const PaintingFileStroke *, ShapePointer> mShapes;
};

} // namespace

Result<ImportedPainting> importPainting(const PaintingFile &file)
{
    return Importing(file).run();
}

} // namespace ductus
