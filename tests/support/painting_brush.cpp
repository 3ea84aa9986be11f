#include "support/painting_brush.h"

#include "painting/blend/blend.h"
#include "painting/edit/look_edits.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr float everywhere = 60; // half width of a stroke around a whole scene

} // namespace

PaintingBrush::Point PaintingBrush::colour(unsigned rgb)
{
    const Eigen::Vector3d encoded(double(rgb >> 16 & 255) / 255, double(rgb >> 8 & 255) / 255,
                                  double(rgb & 255) / 255);
    return linearFromEncoded(encoded).cast<float>();
}

PaintingBrush::Point PaintingBrush::varied(const Point &c, float amount)
{
    const float light = 1 + amount * float(random.uniform(-1, 1));
    const float warm = 0.4f * amount * float(random.uniform(-1, 1));
    return Point(c[0] * light * (1 + warm), c[1] * light, c[2] * light * (1 - warm))
        .cwiseMax(0.f)
        .cwiseMin(1.f);
}

LayerId PaintingBrush::stack(const std::string &name)
{
    return substrate(addStack(name)).id;
}

LayerId PaintingBrush::layer(LayerId under, const std::string &name, BlendMode blend, double opacity,
                             double tolerance)
{
    const StackId stack = painting.stackOf(under)->id;
    const auto found = std::ranges::find(painting.stacks, stack, &Stack::id);
    Layer &made = addLayer(int(found - painting.stacks.begin()), name);
    made.properties.blendMode = blend;
    made.properties.opacity = opacity;
    made.tolerance = tolerance;
    return made.id;
}

LayerId PaintingBrush::sceneLayer(const std::string &name, BlendMode blend, double opacity)
{
    Layer &made = addLayer(-1, name);
    made.properties.blendMode = blend;
    made.properties.opacity = opacity;
    return made.id;
}

ElementId PaintingBrush::stroke(LayerId layer, StrokeSection section, const std::vector<Point> &points,
                                const std::vector<float> &halfWidths, const Point &c, const Point &normal)
{
    StrokeShape shape;
    shape.section = section;
    for (std::size_t i = 0; i < points.size(); ++i)
        shape.points.push_back({points[i], normal, halfWidths[std::min(i, halfWidths.size() - 1)], c, 1.f});
    return add(at(layer), shape);
}

ElementId PaintingBrush::shaded(LayerId layer, StrokeSection section, const std::vector<Point> &points,
                                float halfWidth, const Point &from, const Point &to, const Point &normal)
{
    StrokeShape shape;
    shape.section = section;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const float t = float(i) / float(std::max<std::size_t>(points.size() - 1, 1));
        shape.points.push_back({points[i], normal, halfWidth, (1 - t) * from + t * to, 1.f});
    }
    return add(at(layer), shape);
}

ElementId PaintingBrush::dab(LayerId layer, const Point &centre, float radius, const Point &c, float flat)
{
    const float turn = float(random.uniform(0, 6.28));
    const Point way(std::cos(turn), 0.35f * flat * float(random.uniform(-1, 1)), std::sin(turn));
    const float reach = radius * float(random.uniform(0.45, 0.75));
    return stroke(layer, StrokeSection::Round,
                  {centre - reach * way, centre + Point(0, 0.12f * radius * flat, 0), centre + reach * way},
                  {0.62f * radius, 0.8f * radius, 0.58f * radius}, c);
}

ElementId PaintingBrush::bar(LayerId layer, const Point &from, const Point &to, float halfWidth,
                             const Point &c)
{
    const Point along = (to - from).normalized();
    const Point normal = std::abs(along.y()) > 0.9f ? Point::UnitZ() : Point::UnitY();
    return stroke(layer, StrokeSection::Cube, {from, 0.5f * (from + to), to}, {halfWidth}, c, normal);
}

void PaintingBrush::boards(LayerId layer, const Point &from, const Point &to, bool alongX, float width,
                           const Point &c, float amount, float fill)
{
    const int axis = alongX ? 2 : 0; // planks lie side by side along it
    const float span = to[axis] - from[axis];
    const int count = std::max(1, int(std::lround(std::abs(span) / width)));
    for (int i = 0; i < count; ++i) {
        Point a = from, b = to;
        a[axis] = b[axis] = from[axis] + span * (float(i) + 0.5f) / float(count);
        bar(layer, a, b, 0.5f * std::abs(span) / float(count) * fill, varied(c, amount));
    }
}

std::vector<ElementId> PaintingBrush::copies(LayerId from, LayerId to, const Vec3 &shift, double scale,
                                             std::size_t first)
{
    std::vector<ElementId> made;
    const std::vector<Element> sources = at(from).drawings[0].elements;
    for (std::size_t i = first; i < sources.size(); ++i) {
        Element copy = sources[i];
        copy.id.value = painting.nextId++;
        // About the stroke's own middle, so that a highlight can be a little smaller than its leaf.
        const auto &points = std::get<StrokeShape>(*copy.shape).points;
        Vec3 middle = Vec3::Zero();
        for (const PaintedPoint &point : points)
            middle += point.position.cast<double>() / double(points.size());
        Placement change;
        change.scale = scale;
        change.translation = shift + (1 - scale) * middle;
        copy.placement = change * copy.placement;
        made.push_back(copy.id);
        at(to).drawings[0].elements.push_back(std::move(copy));
    }
    return made;
}

void PaintingBrush::keepLook(const std::string &name)
{
    painting = ductus::addLook(painting, name).painting;
}

void PaintingBrush::everything(LayerId layer, const Point &c)
{
    stroke(layer, StrokeSection::Round, {Point(-1, 0, 0), Point(1, 0, 0)}, {everywhere}, c);
}

void PaintingBrush::camera(const Vec3 &eye, const Vec3 &target, double verticalViewDegrees)
{
    CameraKey key;
    key.eye = eye;
    key.rotation = FrameCamera::lookingAt(eye, target, verticalViewDegrees, 1).rotation;
    key.verticalViewDegrees = verticalViewDegrees;
    painting.camera.keys = {key};
}

} // namespace ductus
