#include "sketchsurfacer/cli/ambiguity_output.h"

#include "formats/png_file.h"
#include "imaging/ambiguity_colours.h"
#include "imaging/surface_picture.h"
#include "surfacing/pipeline/ambiguity.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

namespace ductus {

namespace {

Image picture(const SurfacingState &state, const Ambiguity &ambiguity)
{
    const StrokeSet &strokes = state.sketch->input;
    PictureScene scene;
    PictureMesh mesh;
    mesh.mesh = *state.proxyInInput;
    mesh.drawCreases = false;
    for (double value : ambiguity.shown)
        mesh.vertexColours.push_back(ambiguityColour(value));
    scene.meshes.push_back(std::move(mesh));
    const double diagonal = strokes.box().diagonal();
    for (const Stroke &stroke : strokes.strokes) {
        PictureLine line;
        line.points = stroke.points;
        line.radius = diagonal / 700;
        line.visibleBehind = diagonal / 80;
        scene.lines.push_back(std::move(line));
    }
    PictureOptions options;
    options.zUp = strokes.upAxis == UpAxis::Z;
    return renderPicture(scene, options);
}

std::string json(const SurfacingState &state, const Ambiguity &ambiguity)
{
    using Json = nlohmann::ordered_json;
    Json points = Json::array(), values = Json::array(), readings = Json::array();
    for (const Vec3 &p : state.proxyInInput->vertices)
        points.push_back({p.x(), p.y(), p.z()});
    for (double value : ambiguity.shown)
        values.push_back(std::round(value * 1e4) * 1e-4);
    const double energy = state.labels->segmentation.energy;
    for (const Segmentation &alternative : ambiguity.alternatives)
        readings.push_back({{"models", alternative.models.size()},
                            {"energy", energy > 0.0 ? alternative.energy / energy : 1.0}});
    Json report;
    report["schema"] = "ambiguity";
    report["version"] = 1;
    report["points"] = std::move(points);          // of the proxy, in the unit of the sketch
    report["ambiguity"] = std::move(values);       // beside points, 0: clear .. 1: open
    report["otherReadings"] = std::move(readings); // energy: times that of the surface written
    return report.dump(1) + "\n";
}

} // namespace

Result<std::vector<std::byte>> ambiguityBytes(const SurfacingState &state, const std::filesystem::path &path,
                                              const JobControl &control)
{
    const Result<Ambiguity> ambiguity = findAmbiguity(state, {}, control);
    if (!ambiguity)
        return ambiguity.error();
    if (path.extension() != ".json" && path.extension() != ".JSON")
        return encodePng(picture(state, *ambiguity));
    const std::string text = json(state, *ambiguity);
    const std::span<const std::byte> bytes = std::as_bytes(std::span(text));
    return std::vector<std::byte>(bytes.begin(), bytes.end());
}

} // namespace ductus
