// The sketches the surface command reads: files of other programs and .ductus projects, several merged into
// one.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "strokes/stroke.h"
#include "surfacing/pipeline/surface_options.h"
#include "surfacing/refinement/scribble.h"

#include <filesystem>
#include <optional>

namespace ductus {

struct SketchInput
{
    StrokeSet strokes;                      // of all files in order, ids 0, 1, ...
    std::optional<SurfaceOptions> options;  // as stored, where the only file is a project
    std::optional<TriangleMesh> givenProxy; // of the first project that has one
    std::vector<Scribble> scribbles;        // of all projects in order
    std::vector<std::string> warnings;
};

/// Errors name the file. Projects in another unit than the first file's are brought to its unit.
Result<SketchInput> readSketches(const std::vector<std::filesystem::path> &paths, const JobControl &control);

bool isProjectExtension(const std::filesystem::path &path);

} // namespace ductus
