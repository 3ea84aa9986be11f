// Reading sketches other programs made. The kind is told from the content, the extension only breaks ties.
//
// .curves (CASSIE): blocks "v N" + N lines "x y z";  OBJ with "l" records, also thousands of two-index ones,
// which are chained into strokes at vertices of degree 2;  "CURVE i" text;  plain "x y z" lines, blank lines
// between strokes. Facts: surfacing-research.md section 1.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "strokes/stroke.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ductus {

enum class SketchFileKind { Curves, ObjLines, CurveText, Xyz };

struct SketchFile
{
    StrokeSet strokes; // ids 0, 1, ... in file order
    SketchFileKind kind = SketchFileKind::Curves;
    bool isPointCloud =
        false; // an xyz file whose points do not follow one another: each "stroke" is one point
    std::vector<std::string>
        warnings; // what was skipped, with its place ("hat.curves:12: a stroke of one point")
};

struct SketchReadOptions
{
    int maxPoints = 4'000'000; // more is refused with TooLarge before it fills the memory
};

Result<SketchFile> readSketch(const std::filesystem::path &path, const SketchReadOptions &options,
                              const JobControl &control);

/// The same from memory; \a name stands for the file in messages and its extension breaks ties.
Result<SketchFile> parseSketch(std::string_view bytes, const std::string &name,
                               const SketchReadOptions &options, const JobControl &control);

} // namespace ductus
