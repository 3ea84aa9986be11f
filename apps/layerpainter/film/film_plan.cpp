#include "layerpainter/film/film_plan.h"

#include "layerpainter/document/default_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ductus {

double motionSeconds(const Painting &painting)
{
    if (painting.loopSeconds > 0)
        return painting.loopSeconds;
    double last = 0;
    const auto until = [&](const auto &keys) {
        if (!keys.empty())
            last = std::max(last, keys.back().timeSeconds);
    };
    until(painting.camera.keys);
    for (const MotionGroup &group : painting.motionGroups)
        until(group.keys);
    for (const Layer *layer : painting.layers()) {
        until(layer->motion);
        const std::size_t count = layer->frames.drawingOfFrame.size();
        if (count > 1)
            last = std::max(last, double(count) * std::max(1, layer->frames.repeatCount) /
                                      layer->frames.framesPerSecond);
    }
    return last;
}

int framesOf(double seconds, const FrameRate &rate)
{
    return std::max(1, int(std::lround(std::min(seconds * rate.perSecond(), 1e8))));
}

double secondOf(const FilmPlan &plan, int frame)
{
    return plan.beginSeconds + frame / plan.rate.perSecond();
}

FrameCamera cameraOf(const Painting &painting, const FilmPlan &plan, int frame, double aspect)
{
    if (plan.view == FilmPlan::View::Path && !plan.from)
        return FrameCamera::of(defaultView(painting, secondOf(plan, frame), aspect), aspect);
    CameraKey key = plan.from ? *plan.from : defaultView(painting, plan.beginSeconds, aspect);
    if (plan.view == FilmPlan::View::Turntable) {
        const Box3 box = paintingBox(painting);
        const Vec3 middle = box.isEmpty() ? Vec3::Zero() : box.centre();
        const Eigen::AngleAxisd turn(2 * std::numbers::pi * plan.turns * frame / plan.frames, Vec3::UnitY());
        key.eye = middle + turn * (key.eye - middle);
        key.rotation = turn * key.rotation;
    }
    return FrameCamera::of(key, aspect);
}

} // namespace ductus
