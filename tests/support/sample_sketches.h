// The sketches that come with SketchSurfacer (resources/samples): all drawn by the generator, so that anybody
// can make them again and knows the true surface.
#pragma once

#include "base/result.h"
#include "support/sketch_synthesis.h"

#include <filesystem>

namespace ductus {

struct SampleSketch
{
    std::string id; // also the name of the file
    std::string title;
    std::string lesson; // one line: what can be learned from it
    std::function<Solid()> makeSolid;
    SketchSynthesisOptions options;

    std::string fileName() const { return id + ".curves"; }
};

const std::vector<SampleSketch> &sampleSketches();

/// The strokes in CASSIE's format: a line "v COUNT" before the points of each; five decimals.
std::string curvesText(const StrokeSet &strokes);

struct SampleFile
{
    std::string name;
    std::string content;
};

/// Every bundled file: one .curves a sample, and samples.json, the list of them.
std::vector<SampleFile> sampleFiles();

/// Writes sampleFiles() into \a folder, which is made if need be; with \a meshes also ID-truth.obj each.
Result<void> writeSamples(const std::filesystem::path &folder, bool meshes);

} // namespace ductus
