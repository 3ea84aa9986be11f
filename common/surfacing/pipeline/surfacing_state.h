// SurfacingState: what every stage of the chain made, kept so that a scribble or a moved slider re-runs only
// what it must. All parts are immutable and shared: a copy of a state costs a few pointers, so an undo
// history can hold one an edit.
//
//     prepareSurfacing (sketch, proxy, association)  ->  solveLabels (regions, preview)  ->  extractSurface
//     (mesh)
//
// Each takes a state and returns the next one; the old one stays as it was, also when cancelled.
// surfaceSketch (surface_pipeline.h) is the three in a row. Which of them an edit needs says restart.h.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "geometry/nearest.h"
#include "surfacing/pipeline/surface_options.h"
#include "surfacing/pipeline/surface_result.h"
#include "surfacing/refinement/label_solution.h"
#include "surfacing/refinement/scribble.h"
#include "surfacing/sketch/unit_frame.h"

#include <memory>

namespace ductus {

/// The sketch as the solver sees it.
struct PreparedSketch
{
    StrokeSet input; // as given
    UnitFrame frame;
    StrokeSet strokes;                        // unit frame, even steps, only the solved half
    std::optional<SymmetryPlane> plane;       // unit frame, turned to the solved half
    std::optional<SymmetryProposal> symmetry; // unit frame, if it was looked for and found
    std::vector<std::string> warnings;
};

/// The proxy as the solver sees it.
struct PreparedProxy
{
    PreparedProxy(Proxy made, StrokeSet bordered);

    Proxy proxy; // unit frame, only the solved half, trimmed
    MeshTopology topology;
    NearestOnMesh nearest;
    StrokeSet borderStrokes; // unit frame; an open surface ends along these
};

/// Regions on the proxy, to be shown while the final mesh is still being made.
struct LabelPreview
{
    TriangleMesh mesh;                  // input coordinates, both halves; the proxy cut along region borders
    std::vector<int> triangleRegions;   // index into regions, one a triangle; numbered as in SurfaceResult
    std::vector<SurfaceRegion> regions; // area on the proxy
    std::vector<int> regionIds;         // one a region: names that stay the same from scribble to scribble
    std::vector<char> regionIsLocked;   // one a region
};

struct SurfacingState
{
    SurfaceOptions options; // the parts below were made with
    SurfaceTimings timings; // of the parts below; total is their sum
    std::shared_ptr<const PreparedSketch> sketch;
    std::shared_ptr<const TriangleMesh> givenProxy; // as given, input coordinates; null: made automatically
    std::shared_ptr<const Proxy> roughProxy;        // unit frame, the solved half, not trimmed
    std::shared_ptr<const PreparedProxy> proxy;
    std::shared_ptr<const TriangleMesh> proxyInInput; // input coordinates, both halves: to be shown
    std::shared_ptr<const Association> association;
    std::shared_ptr<const LabelSolution> labels; // null before solveLabels
    std::shared_ptr<const SeamedMesh> seamed;    // the proxy cut along region borders
    std::shared_ptr<const LabelPreview> preview;
    std::shared_ptr<const OptimizedMesh> optimized; // null before extractSurface
    std::shared_ptr<const SurfaceResult> surface;   // the finished thing; null before extractSurface
    int strokeUpdates = 0; // edits of strokes (stroke_update.h) since all was surfaced in one

    bool isPrepared() const { return association != nullptr; }
    bool hasLabels() const { return labels != nullptr; }
    bool hasSurface() const { return surface != nullptr; }
};

/// Sketch, proxy and association. \a strokes as read; \a givenProxy in the same coordinates, or nothing for
/// the automatic one.
Result<SurfacingState> prepareSurfacing(const StrokeSet &strokes,
                                        const std::optional<TriangleMesh> &givenProxy,
                                        const SurfaceOptions &options, const JobControl &control);

/// Regions of \a prepared with all \a scribbles applied, in order. Where \a prepared has labels already, made
/// with the same options and with the first of these scribbles, only the further ones are solved: each is a
/// warm start from the solution before it, so the answer does not depend on whether scribbles came one by one
/// or together. Takes options.segmentation. Fails with InvalidArgument, place "scribble N", for a scribble
/// that cannot be used.
Result<SurfacingState> solveLabels(const SurfacingState &prepared, const std::vector<Scribble> &scribbles,
                                   const SurfaceOptions &options, const JobControl &control);

/// The final mesh of a state with labels, and the tubes of skeletal strokes. Takes options.extraction and
/// options.skeletal.
Result<SurfacingState> extractSurface(const SurfacingState &labelled, const SurfaceOptions &options,
                                      const JobControl &control);

} // namespace ductus
