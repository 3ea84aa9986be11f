#include "doodling/compositing/doodle_painter.h"

#include "doodling/canvas/doodle_time.h"
#include "doodling/compositing/occlusion.h"
#include "doodling/compositing/text_outlines.h"
#include "doodling/prop/prop_solids.h"
#include "doodling/prop/prop_view.h"

#include <algorithm>
#include <mutex>
#include <numeric>
#include <unordered_map>

namespace ductus {

namespace {

constexpr int propSamplesPerAxis = 2; // smooth edges; more costs as many rays more

} // namespace

struct DoodlePainter::Cache
{
    static constexpr std::size_t mostWords = 512;

    TextOutlines fonts;
    std::mutex mutex;
    // The mark is kept, too: an address is not used again while it is.
    std::unordered_map<const DoodleMark *, std::pair<MarkPointer, std::vector<MarkPiece>>> words;
    PropSolids props;
};

DoodlePainter::DoodlePainter() : mCache(std::make_unique<Cache>()) {}
DoodlePainter::~DoodlePainter() = default;

std::vector<MarkPiece> DoodlePainter::pieces(const DoodleFrame &frame) const
{
    std::vector<MarkPiece> all;
    for (const MarkPointer &mark : frame.marks) {
        if (!std::holds_alternative<TextMark>(*mark)) {
            for (MarkPiece &piece : piecesOf(*mark, mCache->fonts))
                all.push_back(std::move(piece));
            continue;
        }
        const std::lock_guard lock(mCache->mutex);
        if (mCache->words.size() > Cache::mostWords)
            mCache->words.clear();
        const auto [place, isNew] = mCache->words.try_emplace(mark.get());
        if (isNew)
            place->second = {mark, piecesOf(*mark, mCache->fonts)};
        all.insert(all.end(), place->second.second.begin(), place->second.second.end());
    }
    return all;
}

PaintedLayer DoodlePainter::propLayer(const Canvas &canvas, const CanvasFrame &place,
                                      const ShotCamera &camera, const DoodleMoment &moment,
                                      const Image &picture) const
{
    const std::shared_ptr<const PaintingSolid> solid = mCache->props.of(*canvas.prop, moment.frame);
    if (!solid)
        return {};
    PropPicture seen = propPicture(*solid, *canvas.prop, place, camera, {0, 0, picture.width, picture.height},
                                   propSamplesPerAxis);
    if (seen.layer.box.isEmpty())
        return {};
    const auto depthOf = [&](const Vec2 &pixel) { return seen.depthAt(pixel, place.depth); };
    const std::vector<float> visibility =
        visibilityOf(canvas.occlusion, moment.shot, moment.frame, depthOf, picture, seen.layer.box);
    for (std::size_t p = 0; p < seen.layer.pixels.size(); ++p)
        seen.layer.pixels[p] *= float(canvas.opacity) * (visibility.empty() ? 1.0f : visibility[p / 4]);
    return std::move(seen.layer);
}

std::vector<PaintedLayer> DoodlePainter::layers(const DoodleMoment &moment, const Image &picture) const
{
    const DoodleScene &scene = moment.scene;
    const std::size_t t = std::size_t(moment.frame);
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < scene.canvases.size() && i < moment.tracks.size(); ++i)
        if (isShownIn(scene.canvases[i], moment.frame) && t < moment.tracks[i].frames.size() &&
            t < moment.shot.cameras.size())
            order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return moment.tracks[a].frames[t].depth > moment.tracks[b].frames[t].depth;
    });
    const ShotCamera camera =
        order.empty() ? ShotCamera()
                      : scaledCamera(moment.shot.cameras[t], double(picture.width) / moment.shot.width);
    std::vector<PaintedLayer> layers;
    for (const std::size_t i : order) {
        const Canvas &canvas = scene.canvases[i];
        if (canvas.prop)
            if (PaintedLayer prop = propLayer(canvas, moment.tracks[i].frames[t], camera, moment, picture);
                !prop.box.isEmpty())
                layers.push_back(std::move(prop));
        const std::optional<int> index = doodleFrameAt(canvas.doodle, moment.frame);
        if (!index)
            continue;
        const CanvasView view(camera, moment.tracks[i].frames[t]);
        PaintedLayer layer = paintedPieces(pieces(canvas.doodle.frames[std::size_t(*index)]), view,
                                           {0, 0, picture.width, picture.height});
        if (layer.box.isEmpty())
            continue;
        const std::vector<float> visibility =
            visibilityOf(canvas.occlusion, moment.shot, moment.frame, view, picture, layer.box);
        for (std::size_t p = 0; p < layer.pixels.size(); ++p)
            layer.pixels[p] *= float(canvas.opacity) * (visibility.empty() ? 1.0f : visibility[p / 4]);
        layers.push_back(std::move(layer));
    }
    return layers;
}

Image DoodlePainter::composited(const DoodleMoment &moment, const Image &picture) const
{
    Image result = picture;
    for (const PaintedLayer &layer : layers(moment, picture))
        layOver(layer, result);
    return result;
}

Image DoodlePainter::alone(const DoodleMoment &moment, const Image &picture) const
{
    Image result(picture.width, picture.height);
    for (const PaintedLayer &layer : layers(moment, picture))
        layOver(layer, result);
    return result;
}

Image DoodlePainter::flat(const DoodleFrame &frame, const Vec2 &size, int width, int height) const
{
    // A camera straight above, so far that the sheet fills the picture.
    ShotCamera camera;
    camera.focal = double(width) / size.x();
    camera.centre = Vec2(0.5 * width, 0.5 * height);
    CanvasFrame place;
    place.position = Vec3(0.0, 0.0, 1.0);
    Image result(width, height);
    layOver(paintedPieces(pieces(frame), CanvasView(camera, place), {0, 0, width, height}), result);
    return result;
}

} // namespace ductus
