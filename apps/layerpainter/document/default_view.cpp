#include "layerpainter/document/default_view.h"

#include "painting/reference/frame_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ductus {

Box3 paintingBox(const Painting &painting)
{
    Box3 box;
    for (const Stack &stack : painting.stacks) {
        for (const Element &element : stack.substrate->drawingAt(0).elements) {
            const Eigen::Affine3d place = element.placement.matrix();
            if (const auto *stroke = std::get_if<StrokeShape>(element.shape.get())) {
                for (const PaintedPoint &point : stroke->points) {
                    const Vec3 middle = place * point.position.cast<double>();
                    const Vec3 reach = Vec3::Constant(element.placement.scale * double(point.halfWidth));
                    box.add(middle - reach);
                    box.add(middle + reach);
                }
            } else {
                for (const Vec3 &vertex : std::get<MeshShape>(*element.shape).mesh.vertices)
                    box.add(place * vertex);
            }
        }
    }
    return box;
}

CameraKey defaultView(const Painting &painting, double timeSeconds, double aspect)
{
    if (!painting.camera.keys.empty())
        return cameraAt(painting.camera, loopedTime(timeSeconds, painting.loopSeconds));
    CameraKey key;
    key.verticalViewDegrees = 40;
    const Box3 box = paintingBox(painting);
    const Vec3 target = box.isEmpty() ? Vec3(0, 0, 0) : box.centre();
    const double radius = box.isEmpty() ? 1 : std::max(0.5 * box.diagonal(), 1e-6);
    const double half = key.verticalViewDegrees * std::numbers::pi / 360;
    const double narrow = std::atan(std::tan(half) * std::min(1.0, aspect));
    key.eye = target + radius / std::sin(narrow) * Vec3(0.35, 0.3, 1).normalized();
    key.rotation = FrameCamera::lookingAt(key.eye, target, key.verticalViewDegrees, aspect).rotation;
    return key;
}

} // namespace ductus
