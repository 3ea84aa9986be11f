// What the layers do to a painting, fixed to the vertices of meshes: for GLB, where artists publish.
// painting.md section 4.
#pragma once

#include "painting/reference/painting_solid.h"

namespace ductus {

struct BakeOptions
{
    PaintingMoment moment;
    double edgeLength = 0.01; // scene units, > 0: how fine; colours are right at vertices and mixed between
    std::int64_t maxVertices = 20'000'000; // more are refused with TooLarge
};

/// The visible substrate of a stack.
struct BakedStack
{
    StackId stack;
    std::string name;
    TriangleMesh mesh;
    std::vector<Eigen::Vector4f> colours; // linear RGB, straight, and opacity; one a vertex
};

/// Stacks in order, hidden and empty ones left out. Strokes become meshes (stroke_mesh.h), meshes are divided
/// until no edge is longer than edgeLength; each vertex gets the colour of its point (PaintingSolid::colour;
/// layers of ToleranceMode::View count as Surface, as there is no view). Errors: InvalidArgument, TooLarge,
/// Cancelled.
Result<std::vector<BakedStack>> bakePainting(const Painting &painting, const BakeOptions &options,
                                             const JobControl &control);

} // namespace ductus
