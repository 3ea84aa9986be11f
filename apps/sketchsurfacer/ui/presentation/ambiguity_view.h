// What a surfaced sketch leaves open, as the viewport draws it: a map of where plausible regions disagree,
// and the other readings to choose from, each with a small picture. Made on a worker; immutable afterwards.
#pragma once

#include "imaging/ambiguity_colours.h"
#include "sketchsurfacer/ui/presentation/result_view.h"

namespace ductus {

/// Another surface the strokes allow.
struct Reading
{
    std::shared_ptr<const SurfacingState> labelled; // for SketchDocument::chooseReading
    Image picture;
    int regionCount = 0;
    double energy = 1.0; // times that of the present surface; the less the likelier
};

struct AmbiguityView
{
    std::shared_ptr<const ResultView> of;
    ViewMesh mesh;                 // the regions' own, in the colours of ambiguityColour
    std::vector<double> values;    // 0: clear .. 1: as open as can be, one a vertex of mesh
    std::vector<Reading> readings; // the most different first
};

struct ReadingPictureOptions
{
    int width = 256, height = 160;
    Vec3 towardsEye = Vec3(0.5, 0.4, 0.75); // scene axes
    Rgba background{38, 41, 46, 255};
};

/// \a result: of a state with labels, not a preview.
Result<std::shared_ptr<const AmbiguityView>> makeAmbiguityView(std::shared_ptr<const ResultView> result,
                                                               UpAxis up,
                                                               const ReadingPictureOptions &pictures,
                                                               const JobControl &control);

} // namespace ductus
