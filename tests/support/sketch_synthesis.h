// From the curves of a known shape to strokes the way people draw them in VR, with the truth kept: wobble and
// misplacement, ends that miss or overshoot, gaps, overdrawing, lines drawn in pieces, lines left out, uneven
// sampling, mirrored pairs. Habits and sizes after the CASSIE sketches: 13-303 strokes of a median length
// near 0.2 of the diagonal, 9 points a stroke, about 1 % of the diagonal imprecise (surfacing.md section 3,
// thesis Fig. III.15).
#pragma once

#include "strokes/stroke.h"
#include "support/solids.h"

#include <cstdint>

namespace ductus {

/// Lengths are shares of the diagonal of the shape's box; probabilities are a feature curve's own.
struct SketchSynthesisOptions
{
    std::uint64_t seed = 1;
    double noise = 0.003;             // root mean square distance of a stroke point from its curve
    double jitter = 0.0003;           // of that, from point to point (a hand trembles, a tracker shakes)
    double overshoot = 0.008;         // an open stroke ends this much too early or too late, at most
    double gapProbability = 0.1;      // a part left out in the middle,
    double gapLength = 0.03;          // this long (half to one and a half of it)
    double overdrawProbability = 0.1; // a second, sometimes a third stroke for the same line,
    double overdrawOffset = 0.006;    // this far beside it
    double splitProbability = 0.3; // a line longer than splitLength drawn as two strokes, both halves again;
                                   // above 0, lines longer than 1.5 diagonals always are
    double splitLength = 0.35;
    double missingShare = 0.0;   // curves nobody drew, whatever their kind
    double flowShare = 1.0;      // of smooth characteristic curves and of smooth borders drawn
    double detailShare = 1.0;    // of detail curves drawn
    double samplingStep = 0.014; // mean distance of points
    double unevenness = 0.6;     // 0: even steps; 1: slow starts, corners and ends like a real hand
    bool mirrorStrokes = false;  // drawn on one half only, the other is its exact image (needs Solid::mirror)
};

/// What is known about a synthetic sketch.
struct GroundTruth
{
    TriangleMesh mesh;
    std::vector<int> triangleFaces;
    int faceCount = 0;
    std::vector<std::vector<Vec3>> creases;      // every sharp part of a feature curve
    std::vector<std::vector<Vec3>> drawnCreases; // those parts of them some stroke covers
    std::vector<std::vector<Vec3>> boundaries;   // where an open shell ends
    std::optional<MirrorPlane> mirror;
};

struct SyntheticSketch
{
    StrokeSet
        strokes; // ids 0, 1, ...; strokes along a boundary have role Boundary; time and pressure are filled
    std::vector<int> strokeCurves; // index in Solid::curves each stroke was drawn from
    GroundTruth truth;
};

/// Deterministic in (solid, options): each curve has its own random stream, so that options of one curve kind
/// leave the strokes of the others as they are. Mirroring is ignored where the solid has no mirror plane.
SyntheticSketch synthesizeSketch(const Solid &solid, const SketchSynthesisOptions &options);

} // namespace ductus
