#include "formats/paintings/quill_scene.h"

#include "formats/paintings/object_fields.h"
#include "formats/paintings/object_stream.h"
#include "formats/paintings/quill_layer.h"

namespace ductus {

using Json = nlohmann::json;

namespace {

constexpr char attempted[] = "Reading the painting";

Error sceneError(const ByteSource &json, std::string problem, ErrorCode code = ErrorCode::Malformed)
{
    return {code, attempted, std::move(problem), "Choose the Quill.json of a Quill project", json.name()};
}

/// The tree below \a root as a list, parents first. Each record is reached once: a number stands for one
/// place.
std::vector<QuillLayer> inOrder(std::vector<QuillLayerRecord> &records, std::uint64_t root)
{
    struct Waiting
    {
        std::uint64_t record;
        int parent;
    };
    std::vector<QuillLayer> layers;
    std::vector<Waiting> waiting{{root, -1}};
    while (!waiting.empty()) {
        const Waiting next = waiting.back();
        waiting.pop_back();
        QuillLayerRecord &record = records[std::size_t(next.record)];
        const int index = int(layers.size());
        layers.push_back(std::move(record.layer));
        layers.back().layer.parent = next.parent;
        for (auto child = record.children.rbegin(); child != record.children.rend(); ++child)
            waiting.push_back({*child, index});
    }
    return layers;
}

void readSequence(const Json &sequence, PaintingFile &painting, std::optional<std::string> &fault)
{
    const ObjectFields fields(sequence, fault);
    painting.framesPerSecond = fields.number("Framerate", 24);
    if (!(painting.framesPerSecond > 0 && painting.framesPerSecond <= 1000))
        fields.fault("Framerate is no rate of frames");
    if (fields.find("BackgroundColor")) {
        Eigen::Vector3d colour = Eigen::Vector3d::Zero();
        fields.numbers("BackgroundColor", colour.data(), 3);
        painting.background = colour.cwiseMax(0).cwiseMin(1).cast<float>();
    }
    if (const Json *metadata = fields.object("Metadata"))
        painting.title = ObjectFields(*metadata, fault).text("Title", "");
}

} // namespace

Result<QuillScene> readQuillScene(ByteSource &json, const JobControl &control)
{
    QuillScene scene;
    std::vector<QuillLayerRecord> records;
    ObjectStreamHooks hooks;
    hooks.objectComplete = [&](Json &object) -> std::optional<Error> {
        object.erase("BoundingBox"); // never to be trusted, and a third of the text
        if (!isQuillLayer(object))
            return std::nullopt;
        Result<QuillLayerRecord> record = quillLayer(object, json.name(), scene.painting.report.notes);
        if (!record)
            return record.error();
        object = takenOut(records.size());
        records.push_back(std::move(*record));
        return std::nullopt;
    };
    const Result<Json> root = readObjectStream(json, hooks, attempted, control);
    if (!root)
        return root.error();
    const auto sequence = root->is_object() ? root->find("Sequence") : root->end();
    if (!root->is_object() || sequence == root->end() || !sequence->is_object())
        return sceneError(json, "this is no Quill scene: it has no Sequence", ErrorCode::Unsupported);
    const auto rootLayer = sequence->find("RootLayer");
    const auto rootNumber = rootLayer == sequence->end() ? std::nullopt : takenOutNumber(*rootLayer);
    if (!rootNumber)
        return sceneError(json, "it has no RootLayer");
    if (records[std::size_t(*rootNumber)].layer.type != "Group")
        return sceneError(json, "its RootLayer is no group");
    std::optional<std::string> fault;
    const double version = ObjectFields(*root, fault).number("Version", 1);
    if (version != 1)
        scene.painting.report.notes.push_back(
            "the scene is of a version that is not known; it was read as 1");
    readSequence(*sequence, scene.painting, fault);
    if (fault)
        return sceneError(json, *fault);
    scene.layers = inOrder(records, *rootNumber);
    return scene;
}

} // namespace ductus
