// ResultView: a solver's state as the viewport draws it: meshes with normals, colours and ambient light,
// creases, shadow. Made on a worker; immutable afterwards, so undo shows a former one at once.
#pragma once

#include "sketchsurfacer/ui/presentation/deviation_map.h"
#include "sketchsurfacer/ui/presentation/region_palette.h"
#include "sketchsurfacer/ui/viewport/sketch_view.h"
#include "surfacing/pipeline/surfacing_state.h"

namespace ductus {

struct RegionView
{
    Rgba colour = {};
    int degree = 0;
    double area = 0.0;       // scene units squared
    double deviation = -1.0; // scene units, mean of the strokes on it; -1: none or not known yet
    bool isLocked = false;
    Vec3 inside = Vec3::Zero(); // a point of the surface well inside it
};

struct ResultView
{
    std::shared_ptr<const SurfacingState> state; // it was made of
    ViewMesh proxy, regions, surface, deviation; // surface and deviation are empty for a preview
    std::vector<int> triangleRegions;            // of regions.mesh
    std::vector<RegionView> regionViews;
    std::vector<std::vector<Vec3>> creases;
    DeviationMap deviationMap;
    std::vector<StrokeId> foundBorders; // found_borders.h
    GroundShadow shadow;
    bool isPreview = false;
    bool isClosed = false;
};

/// \a palette is asked and remembers. Cancelled: an empty view.
Result<std::shared_ptr<const ResultView>> makeResultView(std::shared_ptr<const SurfacingState> state,
                                                         const StrokeSet &strokes, RegionPalette &palette,
                                                         const JobControl &control);

} // namespace ductus
