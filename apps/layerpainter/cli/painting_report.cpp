#include "layerpainter/cli/painting_report.h"

#include <cstdio>
#include <unordered_set>

namespace ductus {

namespace {

struct Counts
{
    int layers = 0;
    int appearanceLayers = 0;
    std::int64_t strokes = 0;
    std::int64_t meshes = 0;
    std::int64_t points = 0;
    std::int64_t triangles = 0;
    std::int64_t shapes = 0; // duplicates share theirs
};

void count(const Layer &layer, Counts &counts, std::unordered_set<const ElementShape *> &seen)
{
    ++counts.layers;
    for (const Drawing &drawing : layer.drawings)
        for (const Element &element : drawing.elements) {
            counts.shapes += seen.insert(element.shape.get()).second;
            if (const auto *stroke = std::get_if<StrokeShape>(element.shape.get())) {
                ++counts.strokes;
                counts.points += std::int64_t(stroke->points.size());
            } else {
                ++counts.meshes;
                counts.triangles += std::get<MeshShape>(*element.shape).mesh.triangleCount();
            }
        }
}

Counts countsOf(const Painting &painting)
{
    Counts counts;
    std::unordered_set<const ElementShape *> seen;
    for (const Layer *layer : painting.layers()) {
        count(*layer, counts, seen);
        counts.appearanceLayers += !isSubstrate(painting, layer->id);
    }
    return counts;
}

nlohmann::ordered_json layerSummary(const Layer &layer, bool isAppearance)
{
    Counts counts;
    std::unordered_set<const ElementShape *> seen;
    count(layer, counts, seen);
    nlohmann::ordered_json json = {{"id", layer.id.value},
                                   {"name", layer.name},
                                   {"visible", layer.properties.visible},
                                   {"locked", layer.locked},
                                   {"opacity", layer.properties.opacity},
                                   {"strokes", counts.strokes},
                                   {"points", counts.points}};
    if (counts.meshes > 0)
        json["meshes"] = counts.meshes;
    if (isAppearance) {
        json["blend"] = blendModeName(layer.properties.blendMode);
        json["tolerance"] = layer.tolerance;
        json["masks"] = layer.properties.masks.size();
    }
    if (layer.frames.drawingOfFrame.size() > 1)
        json["frames"] = layer.frames.drawingOfFrame.size();
    return json;
}

nlohmann::ordered_json stackSummary(const Stack &stack)
{
    nlohmann::ordered_json json = {{"id", stack.id.value}, {"name", stack.name}};
    if (stack.substrate)
        json["substrate"] = layerSummary(*stack.substrate, false);
    json["appearance"] = nlohmann::ordered_json::array();
    for (const Layer &layer : stack.appearance)
        json["appearance"].push_back(layerSummary(layer, true));
    return json;
}

void addLine(std::string &text, const Layer &layer, bool isAppearance)
{
    char line[160];
    std::snprintf(line, sizeof line, ": %d strokes%s%s\n", layer.elementCount(),
                  layer.properties.visible ? "" : ", hidden", layer.locked ? ", locked" : "");
    text += (isAppearance ? "    + " : "  ") + layer.name;
    if (isAppearance && layer.properties.blendMode != BlendMode::Normal)
        text += " (" + std::string(blendModeName(layer.properties.blendMode)) + ")";
    text += line;
}

} // namespace

nlohmann::ordered_json paintingSummary(const Painting &painting)
{
    const Counts counts = countsOf(painting);
    nlohmann::ordered_json json = {{"stacks", painting.stacks.size()},
                                   {"layers", counts.layers},
                                   {"appearanceLayers", counts.appearanceLayers},
                                   {"strokes", counts.strokes},
                                   {"meshes", counts.meshes},
                                   {"points", counts.points},
                                   {"triangles", counts.triangles},
                                   {"shapes", counts.shapes},
                                   {"metresPerUnit", painting.metresPerUnit},
                                   {"loopSeconds", painting.loopSeconds},
                                   {"motionGroups", painting.motionGroups.size()},
                                   {"cameraKeys", painting.camera.keys.size()},
                                   {"pictures", painting.pictures.size()},
                                   {"looks", nlohmann::ordered_json::array()},
                                   {"stackList", nlohmann::ordered_json::array()}};
    for (const Look &look : painting.looks)
        json["looks"].push_back(look.name);
    for (const Stack &stack : painting.stacks)
        json["stackList"].push_back(stackSummary(stack));
    json["sceneStack"] = stackSummary(painting.sceneStack);
    return json;
}

std::string paintingLines(const Painting &painting)
{
    const Counts counts = countsOf(painting);
    char head[200];
    std::snprintf(
        head, sizeof head,
        "%zu stacks, %d layers (%d appearance), %lld strokes, %lld points, %lld meshes, %zu looks\n",
        painting.stacks.size(), counts.layers, counts.appearanceLayers, (long long)counts.strokes,
        (long long)counts.points, (long long)counts.meshes, painting.looks.size());
    std::string text = head;
    for (const Stack &stack : painting.stacks) {
        addLine(text, *stack.substrate, false);
        for (const Layer &layer : stack.appearance)
            addLine(text, layer, true);
    }
    if (!painting.sceneStack.appearance.empty())
        text += "  Scene\n";
    for (const Layer &layer : painting.sceneStack.appearance)
        addLine(text, layer, true);
    for (const Look &look : painting.looks)
        text += "  look: " + look.name + "\n";
    return text;
}

nlohmann::ordered_json importReport(const std::string &input, const ImportedFile &imported)
{
    nlohmann::ordered_json json = {{"schema", "import-report"},
                                   {"version", 1},
                                   {"input", input},
                                   {"kind", imported.kind},
                                   {"name", imported.name},
                                   {"painting", paintingSummary(imported.painting)}};
    const PaintingImportReport &report = imported.report;
    json["file"] = {{"layers", report.layers},
                    {"drawings", report.drawings},
                    {"strokes", report.strokes},
                    {"points", report.points},
                    {"pictures", report.pictures}};
    json["skipped"] = report.skipped;
    std::vector<std::string> notes = report.notes;
    notes.insert(notes.end(), imported.notes.begin(), imported.notes.end());
    json["notes"] = notes;
    return json;
}

} // namespace ductus
