// From a clip and what was drawn into it to a film: frame for frame, at the clip's size and rate, upright,
// with its sound.
#pragma once

#include "doodling/canvas/canvas.h"
#include "doodling/clip/clip.h"
#include "formats/film/film_writer.h"

namespace ductus {

enum class ExportContent {
    Composite, // the clip with the doodles
    Doodle,    // the doodles alone; transparent where the kind of film can be
    Depth      // how far away the scene is: near is light
};

struct FilmExport
{
    FilmKind kind = FilmKind::Mp4;
    ExportContent content = ExportContent::Composite;
    /// The film's lines at most; 0: the clip's. Wider kinds of use want less: a GIF for slides 360.
    int mostLines = 0;
    bool withSound = true;
    /// Of doodles alone in a film without transparency.
    Rgba background = {255, 255, 255, 255};
    int quality = 0; // see FilmOptions
    /// Every second frame, third frame...: for GIFs. The film is as long and its sound the same.
    int everyNth = 1;
};

struct ExportReport
{
    int frames = 0;
    int width = 0, height = 0;
    FrameRate rate;
    bool hasEvenRate = true; // else each frame has the time it has in the clip
    bool hasSound = false;
    std::vector<std::string> warnings; // frames that could not be decoded
};

/// Follows all canvases, then draws and writes frame by frame; a few frames are in memory at a time. \a
/// clipPath: where \a clip was opened, for its sound. A frame of the clip that cannot be decoded shows the
/// one before; the report says so. Cancelled or failed, \a output is as it was. \a progress in frames.
Result<ExportReport> exportFilm(Clip &clip, const std::filesystem::path &clipPath, const Shot &shot,
                                const DoodleScene &scene, const FilmExport &what,
                                const std::filesystem::path &output, const JobControl &control);

/// The tracks of all canvases of \a scene, in its order.
Result<std::vector<CanvasTrack>> tracksOf(const Shot &shot, const DoodleScene &scene,
                                          const JobControl &control);

} // namespace ductus
