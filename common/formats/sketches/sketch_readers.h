// One reader a sketch format, all alike: lines in, strokes out, or an Error with file and line.
#pragma once

#include "formats/sketch_file.h"
#include "formats/text/text_lines.h"

namespace ductus {

/// CASSIE: blocks of "v N" followed by exactly N lines "x y z".
Result<SketchFile> readCurves(TextLines &lines, const SketchReadOptions &options, const JobControl &control);

/// OBJ: "v" and "l" records. An "l" of three or more indices is a stroke; those of two are segments and are
/// chained (segment_chains.h).
Result<SketchFile> readObjLines(TextLines &lines, const SketchReadOptions &options,
                                const JobControl &control);

/// Curve networks: a line "CURVE i" before the "x y z" lines of each stroke.
Result<SketchFile> readCurveText(TextLines &lines, const SketchReadOptions &options,
                                 const JobControl &control);

/// "x y z" lines, blank lines between strokes; further columns (normals) are ignored with a warning. A file
/// whose points do not follow one another is a point cloud (point_order.h).
Result<SketchFile> readXyz(TextLines &lines, const SketchReadOptions &options, const JobControl &control);

} // namespace ductus
