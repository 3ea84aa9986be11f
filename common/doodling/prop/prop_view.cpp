#include "doodling/prop/prop_view.h"

#include "painting/reference/reference_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ductus {

namespace {

constexpr float nowhere = std::numeric_limits<float>::infinity();

Placement worldFromPainting(const Prop &prop, const CanvasFrame &place)
{
    Placement worldFromCanvas;
    worldFromCanvas.rotation = place.worldFromCanvas;
    worldFromCanvas.scale = place.scale;
    worldFromCanvas.translation = place.position;
    return worldFromCanvas * prop.placement;
}

// The camera in the painting's space, looking through the borders of \a box.
FrameCamera frameCamera(const ShotCamera &camera, const Placement &worldFromPainting, const PixelBox &box)
{
    FrameCamera frame;
    const Eigen::Quaterniond back = worldFromPainting.rotation.conjugate();
    frame.eye = back * Vec3((camera.position() - worldFromPainting.translation) / worldFromPainting.scale);
    // A shot's camera has y down and z into the picture.
    const Eigen::Quaterniond turned(Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitX()));
    frame.rotation = (back * Eigen::Quaterniond(camera.worldFromCamera.linear()) * turned).normalized();
    frame.left = (box.left - camera.centre.x()) / camera.focal;
    frame.right = (box.right - camera.centre.x()) / camera.focal;
    frame.up = (camera.centre.y() - box.top) / camera.focal;
    frame.down = (camera.centre.y() - box.bottom) / camera.focal;
    return frame;
}

} // namespace

double PropPicture::depthAt(const Vec2 &pixel, double otherwise) const
{
    const PixelBox &box = layer.box;
    const int x = int(std::floor(pixel.x())), y = int(std::floor(pixel.y()));
    if (x < box.left || x >= box.right || y < box.top || y >= box.bottom)
        return otherwise;
    const float depth =
        depths[std::size_t(y - box.top) * std::size_t(box.width()) + std::size_t(x - box.left)];
    return std::isfinite(depth) ? double(depth) : otherwise;
}

PixelBox propBox(const PaintingSolid &painting, const Prop &prop, const CanvasFrame &place,
                 const ShotCamera &camera, const PixelBox &limits)
{
    Box3 box;
    for (std::size_t i = 0; i < painting.stackCount(); ++i)
        if (const LayerSolid *substrate = painting.substrate(i); substrate && !substrate->box().isEmpty()) {
            box.add(substrate->box().min);
            box.add(substrate->box().max);
        }
    if (box.isEmpty())
        return {};
    const Eigen::Affine3d world = worldFromPainting(prop, place).matrix();
    Vec2 low = Vec2::Constant(1e9), high = Vec2::Constant(-1e9);
    bool isAnyBehind = false, isAnyBefore = false;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 point =
            world * Vec3(corner & 1 ? box.max.x() : box.min.x(), corner & 2 ? box.max.y() : box.min.y(),
                         corner & 4 ? box.max.z() : box.min.z());
        const std::optional<Vec2> pixel = camera.projected(point);
        isAnyBehind = isAnyBehind || !pixel;
        isAnyBefore = isAnyBefore || pixel;
        if (pixel) {
            low = low.cwiseMin(*pixel);
            high = high.cwiseMax(*pixel);
        }
    }
    if (!isAnyBefore)
        return {};
    if (isAnyBehind) // it reaches past the camera: anywhere
        return limits;
    const auto whole = [](double v) { return int(std::clamp(v, -1e6, 1e6)); };
    return PixelBox{whole(std::floor(low.x())) - 1, whole(std::floor(low.y())) - 1,
                    whole(std::ceil(high.x())) + 1, whole(std::ceil(high.y())) + 1}
        .within(limits);
}

PropPicture propPicture(const PaintingSolid &painting, const Prop &prop, const CanvasFrame &place,
                        const ShotCamera &camera, const PixelBox &limits, int samplesPerAxis)
{
    PropPicture picture;
    const PixelBox box = propBox(painting, prop, place, camera, limits);
    if (box.isEmpty())
        return picture;
    const Placement world = worldFromPainting(prop, place);
    ReferenceOptions options;
    options.width = box.width();
    options.height = box.height();
    options.samplesPerAxis = samplesPerAxis;
    options.transparentBackground = true;
    const Result<ReferenceFrame> frame =
        referenceFrame(painting, frameCamera(camera, world, box), options, {});
    if (!frame) // of a camera that sees nothing, such as one within the canvas' plane
        return picture;
    const std::size_t count = std::size_t(box.width()) * std::size_t(box.height());
    picture.layer.box = box;
    picture.layer.pixels.resize(4 * count);
    picture.depths.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t *from = frame->colour.pixels.data() + 4 * i;
        float *to = picture.layer.pixels.data() + 4 * i;
        const float alpha = from[3] / 255.0f;
        for (std::size_t c = 0; c < 3; ++c)
            to[c] = alpha * from[c] / 255.0f;
        to[3] = alpha;
        picture.depths[i] = std::isfinite(frame->depth[i]) ? float(world.scale) * frame->depth[i] : nowhere;
    }
    return picture;
}

} // namespace ductus
