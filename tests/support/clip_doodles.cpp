#include "support/clip_doodles.h"

#include "base/assert.h"
#include "doodling/canvas/edit_doodle.h"
#include "doodling/canvas/edit_scene.h"

#include <cmath>

namespace ductus {

Canvas placedCanvas(const ClipScene &scene, const std::string &name, int frame, const Vec3 &place,
                    const Eigen::Quaterniond &turn)
{
    const ShotCamera camera = scene.camera(frame);
    Canvas canvas;
    canvas.name = name;
    canvas.keyframes.positions = {
        {frame, camera.projected(place).value_or(Vec2(0.0, 0.0)), camera.depthOf(place), false}};
    canvas.keyframes.turns = {{frame, turn, false}};
    return canvas;
}

void keyCanvas(Canvas &canvas, const ClipScene &scene, int frame, const Vec3 &place,
               const Eigen::Quaterniond &turn)
{
    const ShotCamera camera = scene.camera(frame);
    const std::optional<Vec2> pixel = camera.projected(place);
    DUCTUS_ASSERT(pixel);
    canvas.motion = CanvasMotion::Dynamic;
    canvas.turning = CanvasTurning::Still;
    canvas.keyframes.positions.back().interpolatesNext = true;
    canvas.keyframes.turns.back().interpolatesNext = true;
    canvas.keyframes.positions.push_back({frame, *pixel, camera.depthOf(place), true});
    canvas.keyframes.turns.push_back({frame, turn, true});
}

InkStroke penLine(const std::vector<Vec2> &points, double inkWidth, const Rgba &colour)
{
    InkStroke stroke;
    stroke.colour = colour;
    stroke.width = inkWidth;
    for (std::size_t i = 0; i < points.size(); ++i) {
        stroke.line.points.emplace_back(points[i].x(), points[i].y(), 0.0);
        const double share = points.size() > 1 ? double(i) / double(points.size() - 1) : 0.5;
        stroke.line.pressure.push_back(0.45 + 0.55 * std::sin(std::numbers::pi * share));
        stroke.line.timeSeconds.push_back(0.012 * double(i));
    }
    return stroke;
}

std::vector<Vec2> arcPoints(const Vec2 &middle, double rx, double ry, double from, double to)
{
    std::vector<Vec2> points;
    for (int i = 0; i <= 24; ++i) {
        const double angle = from + (to - from) * i / 24.0;
        points.emplace_back(middle + Vec2(rx * std::cos(angle), ry * std::sin(angle)));
    }
    return points;
}

void draw(Canvas &canvas, int drawing, DoodleMark mark)
{
    Result<Doodle> drawn = withMark(canvas.doodle, drawing, std::move(mark));
    DUCTUS_ASSERT(drawn.ok());
    canvas.doodle = std::move(*drawn);
}

void addCanvas(DoodleScene &scene, Canvas canvas)
{
    Result<DoodleScene> result = withCanvas(scene, std::move(canvas));
    DUCTUS_ASSERT(result.ok());
    scene = std::move(*result);
}

} // namespace ductus
