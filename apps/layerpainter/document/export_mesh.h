// Paintings as meshes with colours at their vertices, for programs that know neither strokes nor layers:
// GLB, where artists publish. painting.md section 4.
#pragma once

#include "base/job_control.h"
#include "painting/reference/painting_solid.h"

#include <string>

namespace ductus {

struct MeshExportOptions
{
    PaintingMoment moment;
    double edgeLength = 0; // scene units; 0: as fine as fits into comfortableVertices
};

/// What viewers in web pages turn fluently.
inline constexpr std::int64_t comfortableVertices = 1'500'000;

struct ExportedMesh
{
    std::string bytes; // of a GLB file in metres: a node for each visible stack, colours unlit
    int stacks = 0;
    std::int64_t vertices = 0;
    std::int64_t triangles = 0;
    double edgeLength = 0; // scene units
};

/// TooLittleData if nothing is visible; TooLarge, InvalidArgument and Cancelled as bakePainting().
Result<ExportedMesh> exportedMesh(const Painting &painting, const MeshExportOptions &options,
                                  const JobControl &control);

} // namespace ductus
