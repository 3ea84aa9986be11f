// Films of paintings: turntables, camera paths and motion as MP4, WebM, GIF or numbered PNGs.
#pragma once

#include "base/job_control.h"
#include "layerpainter/film/film_plan.h"
#include "layerpainter/film/frame_maker.h"

#include <filesystem>
#include <string>

namespace ductus {

struct PaintingFilm
{
    FilmPlan plan;
    FrameOptions frames; // transparent: WebM, GIF and PNG; MP4 has none
    std::optional<LookId> look;
    int quality = 0; // FilmOptions::quality
};

/// Writes the film to \a path, whose extension says the kind; without one a folder of PNGs. A film that was
/// cancelled or failed leaves nothing. InvalidArgument for kinds and numbers that do not fit, and all that
/// drawing and writing can meet.
Result<void> writeFilm(std::shared_ptr<const Painting> painting, const PaintingFilm &film,
                       const std::filesystem::path &path, const JobControl &control);

/// A film or picture each look: "night" beside "desk.mp4" becomes "desk-night.mp4". What file names cannot
/// hold is left out; \a number keeps names apart that then are empty.
std::filesystem::path pathForLook(const std::filesystem::path &path, const std::string &look, int number);

} // namespace ductus
