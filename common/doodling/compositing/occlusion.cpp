#include "doodling/compositing/occlusion.h"

#include "doodling/canvas/mark_shape.h"
#include "doodling/compositing/guided_mask.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr int margin = 6; // cells around the box: the picture's edges near its border count, too

// 1 where the canvas is before the scene by the bias, 0 where it is behind by the band more.
double seen(double canvasDepth, double sceneDepth, const CanvasOcclusion &occlusion)
{
    const double behind = (canvasDepth - sceneDepth) / canvasDepth - occlusion.bias;
    if (occlusion.softness <= 0.0)
        return behind > 0.0 ? 0.0 : 1.0;
    const double share = std::clamp(0.5 - behind / occlusion.softness, 0.0, 1.0);
    return share * share * (3.0 - 2.0 * share);
}

CoarseMask coarse(const CanvasOcclusion &occlusion, const Shot &shot, int frame, const DepthOfShown &depthOf,
                  double working, const PixelBox &box, const PixelBox &limits)
{
    CoarseMask mask;
    // Half the depth map's cells: their borders then fall between ours and not into them.
    const double cells = shot.depths.empty() ? 4.0 : shot.depths[std::size_t(frame)].cellSize;
    mask.cellSize = std::max(1.0, 0.5 * cells / working);
    const int reach = int(std::ceil(margin * mask.cellSize));
    const PixelBox wide =
        PixelBox{box.left - reach, box.top - reach, box.right + reach, box.bottom + reach}.within(limits);
    mask.left = wide.left;
    mask.top = wide.top;
    mask.width = std::max(1, int(std::ceil(wide.width() / mask.cellSize)));
    mask.height = std::max(1, int(std::ceil(wide.height() / mask.cellSize)));
    mask.values.reserve(std::size_t(mask.width) * std::size_t(mask.height));
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x) {
            const Vec2 pixel(mask.left + (x + 0.5) * mask.cellSize, mask.top + (y + 0.5) * mask.cellSize);
            const double depth = depthOf(pixel);
            mask.values.push_back(
                depth > 0.0 ? float(seen(depth, shot.depthAt(frame, working * pixel), occlusion)) : 1.0f);
        }
    return mask;
}

// A guided mask comes close to 0 and 1 and seldom reaches them: what is wholly seen must not be a little
// clear.
std::vector<float> withFirmEnds(std::vector<float> values)
{
    constexpr float end = 0.2f;
    for (float &value : values)
        value = std::clamp((value - end) / (1.0f - 2.0f * end), 0.0f, 1.0f);
    return values;
}

void brush(std::vector<float> &visibility, const OcclusionTouch &touch, const std::vector<Vec2> &line,
           double weight, double working, const PixelBox &box)
{
    const double radius = touch.radius / working, soft = std::max(1.0, 0.35 * radius);
    std::vector<Vec2> inPicture;
    Vec2 low = Vec2::Constant(1e300), high = Vec2::Constant(-1e300);
    for (const Vec2 &point : line) {
        inPicture.push_back(point / working);
        low = low.cwiseMin(inPicture.back() - Vec2::Constant(radius));
        high = high.cwiseMax(inPicture.back() + Vec2::Constant(radius));
    }
    const PixelBox touched = PixelBox{int(std::clamp(std::floor(low.x()), -1e6, 1e6)),
                                      int(std::clamp(std::floor(low.y()), -1e6, 1e6)),
                                      int(std::clamp(std::ceil(high.x()), -1e6, 1e6)),
                                      int(std::clamp(std::ceil(high.y()), -1e6, 1e6))}
                                 .within(box);
    const float target = touch.isCanvasInFront ? 1.0f : 0.0f;
    for (int y = touched.top; y < touched.bottom; ++y)
        for (int x = touched.left; x < touched.right; ++x) {
            const double distance = distanceToLine(Vec2(x + 0.5, y + 0.5), inPicture);
            const float share = float(weight * std::clamp((radius - distance) / soft, 0.0, 1.0));
            float &value =
                visibility[std::size_t(y - box.top) * std::size_t(box.width()) + std::size_t(x - box.left)];
            value += share * (target - value);
        }
}

} // namespace

std::vector<Vec2> carriedLine(const OcclusionTouch &touch, const Shot &shot, int frame)
{
    std::vector<Vec2> line = touch.line;
    for (int t = touch.frame; t < frame; ++t)
        for (Vec2 &point : line)
            point += shot.forward[std::size_t(t)].motionAt(point);
    for (int t = touch.frame; t > frame; --t)
        for (Vec2 &point : line)
            point += shot.backward[std::size_t(t - 1)].motionAt(point);
    return line;
}

std::vector<float> visibilityOf(const CanvasOcclusion &occlusion, const Shot &shot, int frame,
                                const CanvasView &view, const Image &picture, const PixelBox &box)
{
    // Beyond the canvas' horizon nothing of it is painted.
    const auto depthOf = [&](const Vec2 &pixel) {
        const std::optional<Vec2> onCanvas = view.canvasPointOf(pixel);
        return onCanvas ? view.depthOf(*onCanvas) : 0.0;
    };
    return visibilityOf(occlusion, shot, frame, depthOf, picture, box);
}

std::vector<float> visibilityOf(const CanvasOcclusion &occlusion, const Shot &shot, int frame,
                                const DepthOfShown &depthOf, const Image &picture, const PixelBox &box)
{
    const double working =
        double(shot.width) / picture.width; // working pixels a pixel of the picture is wide
    const PixelBox limits{0, 0, picture.width, picture.height};
    std::vector<float> visibility;
    if (occlusion.isOn) {
        const CoarseMask mask = coarse(occlusion, shot, frame, depthOf, working, box, limits);
        const auto [least, most] = std::minmax_element(mask.values.begin(), mask.values.end());
        if (*most - *least > 1e-3f)
            visibility = withFirmEnds(guidedMask(mask, picture, box));
        else if (*least < 1.0f)
            visibility.assign(std::size_t(box.width()) * std::size_t(box.height()), *least);
    }
    for (const OcclusionTouch &touch : occlusion.touches) {
        const int steps = std::abs(frame - touch.frame);
        const bool isKnown = touch.frame >= 0 && touch.frame < shot.frameCount() &&
                             int(shot.forward.size()) + 1 >= shot.frameCount() &&
                             int(shot.backward.size()) + 1 >= shot.frameCount();
        if (touch.line.empty() || steps > touch.reach || (steps > 0 && !isKnown))
            continue;
        const double weight = std::clamp(2.0 * (1.0 - double(steps) / (touch.reach + 1)), 0.0, 1.0);
        if (visibility.empty())
            visibility.assign(std::size_t(box.width()) * std::size_t(box.height()), 1.0f);
        brush(visibility, touch, carriedLine(touch, shot, frame), weight, working, box);
    }
    return visibility;
}

} // namespace ductus
