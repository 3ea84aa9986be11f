#include "doodling/reconstruction/shot.h"

namespace ductus {

namespace {

// A plain lens: as wide as a phone's. Without a known depth its only effect is how canvases foreshorten.
constexpr double focalShareOfWidth = 0.9;

} // namespace

double Shot::depthAt(int frame, const Vec2 &pixel) const
{
    return depths.empty() ? sceneDepth : depths[std::size_t(frame)].depthAt(pixel);
}

int Shot::objectAt(int frame, const Vec2 &pixel) const
{
    return depths.empty() ? 0 : depths[std::size_t(frame)].objectAt(pixel);
}

Result<Shot> reconstructShot(Clip &clip, const ShotOptions &options, const JobControl &control)
{
    Shot shot;
    shot.clipWidth = clip.info().width;
    shot.clipHeight = clip.info().height;
    Image before;
    for (int t = 0; t < clip.info().frameCount; ++t) {
        if (control.isCancelled())
            return cancelledError("Finding how the scene moves");
        control.progress(double(t) / clip.info().frameCount, "Finding how the scene moves");
        Result<Image> frame = clip.frame(t, options.mostLines);
        if (!frame)
            return frame.error();
        shot.features.push_back(featuresOf(*frame));
        if (t > 0) {
            FlowPair flow = denseFlow(before, *frame, options.flow);
            shot.forward.push_back(std::move(flow.forward));
            shot.backward.push_back(std::move(flow.backward));
        }
        before = std::move(*frame);
    }
    shot.width = before.width;
    shot.height = before.height;
    ShotCamera camera;
    camera.focal = focalShareOfWidth * shot.width;
    camera.centre = Vec2(0.5 * shot.width, 0.5 * shot.height);
    shot.cameras.assign(std::size_t(clip.info().frameCount), camera);
    return shot;
}

} // namespace ductus
