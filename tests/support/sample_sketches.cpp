#include "support/sample_sketches.h"

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

namespace ductus {

namespace {

std::string pointText(const Vec3 &point)
{
    std::string text;
    for (int k = 0; k < 3; ++k) {
        char buffer[64];
        std::snprintf(buffer, sizeof buffer, "%.5f", point[k]);
        const std::string number = buffer;
        text += (k ? " " : "") + (number == "-0.00000" ? std::string("0.00000") : number);
    }
    return text;
}

std::string objText(const TriangleMesh &mesh)
{
    std::string text;
    for (const Vec3 &vertex : mesh.vertices)
        text += "v " + pointText(vertex) + "\n";
    for (const Triangle &t : mesh.triangles)
        text += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " +
                std::to_string(t[2] + 1) + "\n";
    return text;
}

nlohmann::ordered_json describe(const SampleSketch &sample, const Solid &solid, const SyntheticSketch &sketch)
{
    nlohmann::ordered_json json;
    json["id"] = sample.id;
    json["title"] = sample.title;
    json["lesson"] = sample.lesson;
    json["file"] = sample.fileName();
    json["strokes"] = sketch.strokes.strokes.size();
    json["boundaryStrokes"] = nlohmann::ordered_json::array();
    for (const Stroke &stroke : sketch.strokes.strokes)
        if (stroke.role == StrokeRole::Boundary)
            json["boundaryStrokes"].push_back(stroke.id.value);
    json["open"] = solid.isOpen;
    // Only an exact pair of halves is worth solving as one; [nx, ny, nz, d] as --symmetry takes it.
    json["symmetry"] = nullptr;
    if (sample.options.mirrorStrokes && solid.mirror)
        json["symmetry"] = {solid.mirror->normal.x(), solid.mirror->normal.y(), solid.mirror->normal.z(),
                            solid.mirror->offset};
    return json;
}

Result<void> writeText(const std::filesystem::path &path, const std::string &text)
{
    std::ofstream stream(path, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream)
        return Error{ErrorCode::WriteFailed, "Writing the samples", "the file could not be written",
                     "Check the folder's permissions and free space", path.string()};
    return {};
}

} // namespace

const std::vector<SampleSketch> &sampleSketches()
{
    static const std::vector<SampleSketch> samples{
        {"car",
         "Saloon car",
         "Symmetric sketch with sharp shoulder, pillars and detail strokes: half is solved and mirrored.",
         [] { return car(); },
         {.seed = 7,
          .noise = 0.0018,
          .gapProbability = 0.06,
          .overdrawProbability = 0.08,
          .mirrorStrokes = true}},
        {"bottle",
         "Bottle",
         "Round shapes with sharp rings: a crease at the shoulder, none along the meridians.",
         [] { return bottle(); },
         {.seed = 3, .noise = 0.0025, .overdrawProbability = 0.2}},
        {"bevelled-box",
         "Box with a bevel",
         "Flat faces meet in straight edges although every stroke is a little off.",
         [] { return bevelledBox(); },
         {.seed = 5, .noise = 0.003, .overshoot = 0.015, .overdrawProbability = 0.25}},
        {"bent-leaf",
         "Folded leaf",
         "An open shell: boundary strokes say where the surface ends, the midrib is a fold.",
         [] { return bentLeaf(); },
         {.seed = 11, .noise = 0.0025}},
        {"computer-mouse",
         "Computer mouse",
         "A smooth dome with a sharp belt: detail strokes lie on the surface and bend nothing.",
         [] { return computerMouse(); },
         {.seed = 2, .noise = 0.0025, .overdrawProbability = 0.15}},
        {"table-lamp",
         "Table lamp",
         "Thick and thin parts in one sketch: the stem needs a tight proxy.",
         [] { return tableLamp(); },
         {.seed = 9, .noise = 0.002}},
        {"iron",
         "Iron with a handle",
         "A closed surface with a hole: the proxy must find the way through the handle.",
         [] { return iron(); },
         {.seed = 4, .noise = 0.0018, .overdrawProbability = 0.06, .mirrorStrokes = true}},
    };
    return samples;
}

std::string curvesText(const StrokeSet &strokes)
{
    std::string text;
    for (const Stroke &stroke : strokes.strokes) {
        text += "v " + std::to_string(stroke.points.size()) + "\n";
        for (const Vec3 &point : stroke.points)
            text += pointText(point) + "\n";
    }
    return text;
}

std::vector<SampleFile> sampleFiles()
{
    std::vector<SampleFile> files;
    nlohmann::ordered_json list;
    list["version"] = 1;
    list["made-by"] = "make_samples; all shapes and strokes are the project's own";
    list["metresPerUnit"] = 1.0;
    list["upAxis"] = "y";
    list["samples"] = nlohmann::ordered_json::array();
    for (const SampleSketch &sample : sampleSketches()) {
        const Solid solid = sample.makeSolid();
        const SyntheticSketch sketch = synthesizeSketch(solid, sample.options);
        files.push_back({sample.fileName(), curvesText(sketch.strokes)});
        list["samples"].push_back(describe(sample, solid, sketch));
    }
    files.push_back({"samples.json", list.dump(2) + "\n"});
    return files;
}

Result<void> writeSamples(const std::filesystem::path &folder, bool meshes)
{
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure)
        return Error{ErrorCode::WriteFailed, "Writing the samples", failure.message(),
                     "Choose another folder", folder.string()};
    for (const SampleFile &file : sampleFiles())
        if (const auto written = writeText(folder / file.name, file.content); !written)
            return written;
    if (!meshes)
        return {};
    for (const SampleSketch &sample : sampleSketches())
        if (const auto written =
                writeText(folder / (sample.id + "-truth.obj"), objText(sample.makeSolid().mesh));
            !written)
            return written;
    return {};
}

} // namespace ductus
