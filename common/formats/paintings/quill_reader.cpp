#include "formats/paintings/painting_readers.h"
#include "formats/paintings/quill_drawing.h"
#include "formats/paintings/quill_scene.h"

#include <algorithm>
#include <map>
#include <set>

namespace ductus {

namespace {

constexpr char attempted[] = "Reading the painting";
constexpr std::uint64_t fileHeaderSize = 8;

using DrawingPointer = std::shared_ptr<const PaintingFileDrawing>;

/// Indices of the drawings that frames show, each once, in order of their index.
std::vector<int> shownDrawings(const QuillLayer &layer, bool firstFrameOnly)
{
    const std::vector<int> &frames = layer.layer.frames;
    const auto end = firstFrameOnly && !frames.empty() ? frames.begin() + 1 : frames.end();
    const std::set<int> shown(frames.begin(), end);
    return {shown.begin(), shown.end()};
}

Error missingData(const ByteSource &json, const QuillLayer &layer)
{
    return {ErrorCode::FileNotFound, attempted,
            "the file with the strokes, Quill.qbin, is missing (layer \"" + layer.layer.name + "\" needs it)",
            "Put Quill.qbin beside Quill.json: a Quill project is the whole folder", json.name()};
}

class QuillAssembly
{
public:
    QuillAssembly(QuillScene scene, ByteSource &json, ByteSource *qbin, const PaintingReadOptions &options)
        : mScene(std::move(scene)), mJson(json), mQbin(qbin), mOptions(options)
    {
        mTally.maxPoints = options.maxPoints;
    }

    Result<PaintingFile> run(const JobControl &control)
    {
        if (const auto error = readDrawings(control))
            return *error;
        PaintingFile &painting = mScene.painting;
        for (QuillLayer &layer : mScene.layers) {
            painting.layers.push_back(std::move(layer.layer));
            if (const auto error = fillLayer(layer, int(painting.layers.size()) - 1))
                return *error;
        }
        painting.report.layers = int(painting.layers.size());
        noteTally();
        return std::move(painting);
    }

private:
    /// In order of their place, so that a packed file is unpacked once.
    std::optional<Error> readDrawings(const JobControl &control)
    {
        for (const QuillLayer &layer : mScene.layers)
            for (const int index : shownDrawings(layer, mOptions.firstFrameOnly))
                mDrawings[layer.drawingOffsets[std::size_t(index)]];
        if (mDrawings.empty())
            return std::nullopt;
        if (!mQbin)
            return missingData(mJson, firstWithDrawings());
        std::uint64_t bytesRead = 0;
        for (auto &[offset, drawing] : mDrawings) {
            control.progress(double(offset) / double(mQbin->size() + 1), attempted);
            if (offset < fileHeaderSize)
                return Error{ErrorCode::Malformed, attempted, "a drawing lies inside the file's header",
                             "Save the project again in Quill", mQbin->place(offset)};
            Result<QuillDrawingRead> read = readQuillDrawing(*mQbin, offset, mTally, control);
            if (!read)
                return read.error();
            // Drawings that overlap could ask for any amount of memory.
            bytesRead += read->end - offset;
            if (bytesRead > mQbin->size())
                return Error{ErrorCode::Malformed, attempted, "drawings overlap one another",
                             "Save the project again in Quill", mQbin->place(offset)};
            mScene.painting.report.strokes += int(read->drawing.strokes.size());
            drawing = std::make_shared<const PaintingFileDrawing>(std::move(read->drawing));
        }
        mScene.painting.report.drawings = int(mDrawings.size());
        mScene.painting.report.points = mTally.points;
        return std::nullopt;
    }

    const QuillLayer &firstWithDrawings() const
    {
        return *std::find_if(mScene.layers.begin(), mScene.layers.end(),
                             [](const QuillLayer &layer) { return !layer.drawingOffsets.empty(); });
    }

    std::optional<Error> fillLayer(const QuillLayer &source, int index)
    {
        PaintingFileLayer &layer = mScene.painting.layers[std::size_t(index)];
        PaintingImportReport &report = mScene.painting.report;
        const std::string path = mScene.painting.pathOf(index);
        if (layer.kind == PaintingFileLayerKind::Paint) {
            fillFrames(source, layer, path);
        } else if (layer.kind == PaintingFileLayerKind::Picture) {
            if (const auto error = fillPicture(source, layer, path))
                return error;
        } else if (layer.kind == PaintingFileLayerKind::Other) {
            report.skipped.push_back(path + ": " + source.type + " layers are not imported");
            report.unseenSkips += source.type == "Viewpoint";
        }
        return std::nullopt;
    }

    void fillFrames(const QuillLayer &source, PaintingFileLayer &layer, const std::string &path)
    {
        // mScene.layers' own frames have been moved into layer.
        std::set<int> shown(layer.frames.begin(), layer.frames.end());
        if (mOptions.firstFrameOnly && !layer.frames.empty()) {
            layer.frames.resize(1);
            shown = {layer.frames[0]};
        }
        std::map<int, int> place; // from the file's drawings to those read
        for (const int index : shown) {
            place[index] = int(layer.drawings.size());
            layer.drawings.push_back(mDrawings.at(source.drawingOffsets[std::size_t(index)]));
        }
        for (int &frame : layer.frames)
            frame = place.at(frame);
        const std::size_t unused = source.drawingOffsets.size() - shown.size();
        if (unused > 0)
            mScene.painting.report.skipped.push_back(path + ": " + std::to_string(unused) +
                                                     (unused == 1 ? " drawing" : " drawings") +
                                                     " that no frame shows");
    }

    std::optional<Error> fillPicture(const QuillLayer &source, PaintingFileLayer &layer,
                                     const std::string &path)
    {
        PaintingImportReport &report = mScene.painting.report;
        if (!source.dataOffset || !mQbin) {
            report.skipped.push_back(path + ": the picture itself is not in the project");
            return std::nullopt;
        }
        Result<Image> picture = readQuillPicture(*mQbin, *source.dataOffset, mOptions.maxPicturePixels);
        if (!picture && picture.error().code == ErrorCode::Unsupported) {
            report.skipped.push_back(path + ": " + picture.error().problem);
            return std::nullopt;
        }
        if (!picture)
            return picture.error();
        // Many layers could name one place.
        mPictureBytes += std::uint64_t(picture->width) * std::uint64_t(picture->height) * 3;
        if (mPictureBytes > mQbin->size())
            return Error{ErrorCode::Malformed, attempted, "pictures overlap one another",
                         "Save the project again in Quill", mQbin->place(*source.dataOffset)};
        layer.picture = std::move(*picture);
        ++report.pictures;
        return std::nullopt;
    }

    void noteTally()
    {
        std::vector<std::string> &notes = mScene.painting.report.notes;
        if (mTally.clampedValues > 0)
            notes.push_back(
                std::to_string(mTally.clampedValues) +
                " points had colours or opacities outside 0..1 or negative widths; they were clamped");
        if (mTally.unknownBrushes > 0)
            notes.push_back(std::to_string(mTally.unknownBrushes) +
                            " strokes have a brush that is not known; they were read as round");
    }

    QuillScene mScene;
    ByteSource &mJson;
    ByteSource *mQbin;
    const PaintingReadOptions &mOptions;
    QuillDrawingTally mTally;
    std::map<std::uint64_t, DrawingPointer> mDrawings; // by place; layers that name one place share it
    std::uint64_t mPictureBytes = 0;
};

} // namespace

Result<PaintingFile> readQuill(ByteSource &json, ByteSource *qbin, const PaintingReadOptions &options,
                               const JobControl &control)
{
    Result<QuillScene> scene = readQuillScene(json, control.part(0, 0.3));
    if (!scene)
        return scene.error();
    return QuillAssembly(std::move(*scene), json, qbin, options).run(control.part(0.3, 1));
}

} // namespace ductus
