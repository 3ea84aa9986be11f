// What a film of a painting shows: from when to when, and from where.
#pragma once

#include "formats/film/frame_rate.h"
#include "painting/reference/frame_camera.h"
#include "painting/scene/painting.h"

#include <optional>

namespace ductus {

struct FilmPlan
{
    enum class View {
        Path,      // the painting's camera path; without one as Still
        Still,     // always from `from`
        Turntable, // once around the vertical through the painting's middle, beginning at `from`
    };
    View view = View::Path;
    std::optional<CameraKey> from; // none: as the painting is first seen
    double turns = 1;              // of the turntable; < 0 the other way round
    double beginSeconds = 0;       // of the motion
    int frames = 0;                // >= 1
    FrameRate rate = {25, 1};
};

/// How long the painting moves: its loop, else until its last key or the end of its drawings; 0 if nothing
/// does.
double motionSeconds(const Painting &painting);

/// Frames for a film of \a seconds, at least one. A film that loops does not show its first frame again.
int framesOf(double seconds, const FrameRate &rate);

/// The painting's second at frame number \a frame.
double secondOf(const FilmPlan &plan, int frame);

FrameCamera cameraOf(const Painting &painting, const FilmPlan &plan, int frame, double aspect);

} // namespace ductus
