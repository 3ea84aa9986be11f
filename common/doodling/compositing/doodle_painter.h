// DoodlePainter: the doodles of a frame, over the frame or alone. On the processor, the same bytes
// everywhere; the export and the player use it both.
#pragma once

#include "doodling/canvas/canvas.h"
#include "doodling/compositing/layer.h"

#include <memory>
#include <span>

namespace ductus {

/// Everything that decides what a frame's doodles look like.
struct DoodleMoment
{
    const Shot &shot;
    const DoodleScene &scene;
    std::span<const CanvasTrack> tracks; // one a canvas, in the scene's order; without frames: not painted
    int frame = 0;
};

class DoodlePainter
{
public:
    DoodlePainter();
    ~DoodlePainter();

    /// \a picture (the moment's frame, at any size: the clip's, or smaller for previews) with the doodles
    /// over it.
    Image composited(const DoodleMoment &moment, const Image &picture) const;

    /// The doodles alone, over nothing, straight alpha; \a picture tells the size and where silhouettes are.
    Image alone(const DoodleMoment &moment, const Image &picture) const;

    /// A frame of a doodle seen straight from above, over nothing: the sheet's \a size (canvas units) is \a
    /// width by \a height pixels. For the drawing panel, onion skins and thumbnails.
    Image flat(const DoodleFrame &frame, const Vec2 &size, int width, int height) const;

private:
    struct Cache;
    /// The marks' pieces; words are kept from frame to frame.
    std::vector<MarkPiece> pieces(const DoodleFrame &frame) const;
    /// The prop of \a canvas where nothing filmed hides it; no pixels if it is not seen.
    PaintedLayer propLayer(const Canvas &canvas, const CanvasFrame &place, const ShotCamera &camera,
                           const DoodleMoment &moment, const Image &picture) const;
    std::vector<PaintedLayer> layers(const DoodleMoment &moment, const Image &picture) const;

    std::unique_ptr<Cache> mCache;
};

} // namespace ductus
