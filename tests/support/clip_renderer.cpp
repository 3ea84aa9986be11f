#include "base/parallel.h"
#include "support/clip_scenes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ductus {

namespace {

constexpr int samplesASide = 3; // of a pixel's colour

// A panel where it stands in one frame.
struct PlacedPanel
{
    const ClipPanel *panel = nullptr;
    int body = 0;
    Vec3 centre, normal;
    Vec3 right, down; // scaled so that dot(point - centre) is -1..1 on the panel
};

struct Hit
{
    const PlacedPanel *panel = nullptr;
    double depth = std::numeric_limits<double>::infinity();
    double a = 0.0, b = 0.0; // -1..1 on the panel
};

Eigen::Isometry3d placeOf(const ClipBody &body, int frame)
{
    return body.worldFromBody ? body.worldFromBody(frame) : Eigen::Isometry3d::Identity();
}

std::vector<PlacedPanel> placed(const ClipScene &scene, int frame)
{
    std::vector<PlacedPanel> panels;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const Eigen::Isometry3d place = placeOf(scene.bodies[i], frame);
        for (const ClipPanel &panel : scene.bodies[i].panels)
            panels.push_back({&panel, int(i), place * panel.centre,
                              place.linear() * panel.right.cross(panel.down).normalized(),
                              place.linear() * panel.right / panel.right.squaredNorm(),
                              place.linear() * panel.down / panel.down.squaredNorm()});
    }
    return panels;
}

Hit cast(const std::vector<PlacedPanel> &panels, const ShotCamera &camera, const Vec2 &pixel)
{
    const Vec3 origin = camera.position(), ray = camera.rayOf(pixel);
    Hit hit;
    for (const PlacedPanel &panel : panels) {
        const double slope = panel.normal.dot(ray);
        if (std::abs(slope) < 1e-12)
            continue;
        const double depth = panel.normal.dot(panel.centre - origin) / slope;
        if (depth <= 1e-6 || depth >= hit.depth)
            continue;
        const Vec3 offset = origin + depth * ray - panel.centre;
        const double a = panel.right.dot(offset), b = panel.down.dot(offset);
        const bool isOn =
            panel.panel->isRound ? a * a + b * b <= 1.0 : std::abs(a) <= 1.0 && std::abs(b) <= 1.0;
        if (isOn)
            hit = {&panel, depth, a, b};
    }
    return hit;
}

Eigen::Vector3f colourOf(const Hit &hit)
{
    if (!hit.panel)
        return Eigen::Vector3f(0.7f, 0.8f, 0.95f);
    const ClipPanel &panel = *hit.panel->panel;
    // Fixed light from above left: sides of a box differ.
    const Vec3 normal = panel.right.cross(panel.down).normalized();
    const float light = float(0.8 + 0.2 * std::abs(normal.dot(Vec3(0.3, 0.8, 0.5))));
    return light * ductus::colourOf(panel.texture, hit.a * panel.right.norm(), hit.b * panel.down.norm());
}

Image imageOf(const ClipScene &scene, const std::vector<PlacedPanel> &panels, const ShotCamera &camera)
{
    Image image(scene.width, scene.height);
    parallelFor(0, std::size_t(scene.height), [&](std::size_t y) {
        for (int x = 0; x < scene.width; ++x) {
            Eigen::Vector3f sum = Eigen::Vector3f::Zero();
            for (int j = 0; j < samplesASide; ++j)
                for (int i = 0; i < samplesASide; ++i)
                    sum +=
                        colourOf(cast(panels, camera,
                                      {x + (i + 0.5) / samplesASide, double(y) + (j + 0.5) / samplesASide}));
            sum *= 255.0f / float(samplesASide * samplesASide);
            image.set(x, int(y),
                      {std::uint8_t(std::lround(sum[0])), std::uint8_t(std::lround(sum[1])),
                       std::uint8_t(std::lround(sum[2])), 255});
        }
    });
    return image;
}

bool isInside(const ClipScene &scene, const Vec2 &pixel)
{
    return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() < scene.width && pixel.y() < scene.height;
}

// Whether a point of the scene at \a depth before \a camera is what is seen at \a pixel.
bool isSeen(const std::vector<PlacedPanel> &panels, const ShotCamera &camera, const Vec2 &pixel, double depth)
{
    return cast(panels, camera, pixel).depth > depth * (1.0 - 1e-6) - 1e-6;
}

// Where the point of a hit of \a frame is in \a other.
Vec3 carried(const ClipScene &scene, const Hit &hit, const Vec3 &point, int frame, int other)
{
    const ClipBody &body = scene.bodies[std::size_t(hit.panel->body)];
    return placeOf(body, other) * (placeOf(body, frame).inverse() * point);
}

struct Motion
{
    Eigen::Vector2f pixels = Eigen::Vector2f::Zero();
    bool isSeen = false;
};

Motion motionOf(const ClipScene &scene, const Hit &hit, const Vec2 &pixel, int frame, int other,
                const std::vector<PlacedPanel> &panelsThere)
{
    if (!hit.panel)
        return {};
    const Vec3 point = scene.camera(frame).unprojected(pixel, hit.depth);
    const Vec3 there = carried(scene, hit, point, frame, other);
    const ShotCamera camera = scene.camera(other);
    const std::optional<Vec2> seenAt = camera.projected(there);
    if (!seenAt)
        return {};
    return {(*seenAt - pixel).cast<float>(),
            isInside(scene, *seenAt) && isSeen(panelsThere, camera, *seenAt, camera.depthOf(there))};
}

FlowField flowOf(const ClipScene &scene, int from, int to, int cellSize)
{
    FlowField field;
    field.width = (scene.width + cellSize - 1) / cellSize;
    field.height = (scene.height + cellSize - 1) / cellSize;
    field.cellSize = cellSize;
    const ShotCamera camera = scene.camera(from);
    const std::vector<PlacedPanel> here = placed(scene, from), there = placed(scene, to);
    for (int y = 0; y < field.height; ++y)
        for (int x = 0; x < field.width; ++x) {
            const Vec2 pixel = Vec2(x + 0.5, y + 0.5) * cellSize;
            const Motion motion = motionOf(scene, cast(here, camera, pixel), pixel, from, to, there);
            field.motions.push_back(motion.pixels);
            field.confidences.push_back(motion.isSeen ? 1.0f : 0.05f);
        }
    return field;
}

DepthMap depthsOf(const ClipScene &scene, int frame, int cellSize)
{
    const int width = (scene.width + cellSize - 1) / cellSize;
    const int height = (scene.height + cellSize - 1) / cellSize;
    const ShotCamera camera = scene.camera(frame);
    const std::vector<PlacedPanel> panels = placed(scene, frame);
    std::vector<float> disparities;
    std::vector<std::uint8_t> objects;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Hit hit = cast(panels, camera, Vec2(x + 0.5, y + 0.5) * cellSize);
            disparities.push_back(hit.panel ? float(1.0 / hit.depth) : 0.0f);
            const bool moves =
                hit.panel && scene.bodies[std::size_t(hit.panel->body)].worldFromBody != nullptr;
            objects.push_back(moves ? std::uint8_t(hit.panel->body + 1) : std::uint8_t(0));
        }
    DepthMap map = depthMapOf(width, height, cellSize, disparities);
    map.objects = std::move(objects);
    return map;
}

class RenderedClip : public Clip
{
public:
    explicit RenderedClip(ClipScene scene) : mScene(std::move(scene))
    {
        mInfo.frameCount = mScene.frameCount;
        mInfo.width = mScene.width;
        mInfo.height = mScene.height;
        mInfo.framesPerSecond = 25.0;
        for (int t = 0; t < mScene.frameCount; ++t)
            mInfo.frameTimes.push_back(t / 25.0);
        mInfo.codec = "synthetic";
    }
    const ClipInfo &info() const override { return mInfo; }
    Result<Image> frame(int index, int) override { return renderedImage(mScene, index); }

private:
    ClipScene mScene;
    ClipInfo mInfo;
};

} // namespace

Image renderedImage(const ClipScene &scene, int frame)
{
    return imageOf(scene, placed(scene, frame), scene.camera(frame));
}

ClipTruth renderedFrame(const ClipScene &scene, int frame)
{
    const ShotCamera camera = scene.camera(frame);
    const std::vector<PlacedPanel> panels = placed(scene, frame);
    const int next = std::min(frame + 1, scene.frameCount - 1);
    const std::vector<PlacedPanel> panelsNext = placed(scene, next);
    ClipTruth truth;
    truth.image = imageOf(scene, panels, camera);
    for (int y = 0; y < scene.height; ++y)
        for (int x = 0; x < scene.width; ++x) {
            const Vec2 pixel(x + 0.5, y + 0.5);
            const Hit hit = cast(panels, camera, pixel);
            const Motion motion = motionOf(scene, hit, pixel, frame, next, panelsNext);
            truth.depths.push_back(float(hit.depth));
            truth.bodies.push_back(hit.panel ? hit.panel->body : -1);
            truth.motions.push_back(motion.pixels);
            truth.isSeenNext.push_back(motion.isSeen);
        }
    return truth;
}

ClipTrack trackOf(const ClipScene &scene, int frame, const Vec2 &pixel)
{
    ClipTrack track;
    const std::vector<PlacedPanel> panels = placed(scene, frame);
    const Hit hit = cast(panels, scene.camera(frame), pixel);
    if (!hit.panel)
        return track;
    const Vec3 point = scene.camera(frame).unprojected(pixel, hit.depth);
    for (int t = 0; t < scene.frameCount; ++t) {
        const Vec3 place = carried(scene, hit, point, frame, t);
        const ShotCamera camera = scene.camera(t);
        const std::optional<Vec2> seenAt = camera.projected(place);
        track.positions.push_back(place);
        track.depths.push_back(camera.depthOf(place));
        track.pixels.push_back(seenAt.value_or(Vec2(-1.0, -1.0)));
        track.isVisible.push_back(seenAt && isInside(scene, *seenAt) &&
                                  isSeen(placed(scene, t), camera, *seenAt, camera.depthOf(place)));
    }
    return track;
}

std::unique_ptr<Clip> clipOf(const ClipScene &scene)
{
    return std::make_unique<RenderedClip>(scene);
}

Shot trueShot(const ClipScene &scene, int cellSize)
{
    Shot shot;
    shot.width = shot.clipWidth = scene.width;
    shot.height = shot.clipHeight = scene.height;
    shot.knowledge = CameraKnowledge::SolvedCameras;
    for (int t = 0; t < scene.frameCount; ++t) {
        shot.cameras.push_back(scene.camera(t));
        shot.depths.push_back(depthsOf(scene, t, cellSize));
        if (t + 1 < scene.frameCount) {
            shot.forward.push_back(flowOf(scene, t, t + 1, cellSize));
            shot.backward.push_back(flowOf(scene, t + 1, t, cellSize));
        }
    }
    return shot;
}

} // namespace ductus
