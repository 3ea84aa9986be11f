// Asks scenes point by point what they must look like, and names the colours they are painted with.
#pragma once

#include "painting/reference/reference_frame.h"
#include "support/painting_scenes.h"

#include <optional>
#include <vector>

namespace ductus {

struct Probe
{
    std::optional<SubstratePoint> point;              // nothing there
    Eigen::Vector3d colour = Eigen::Vector3d::Zero(); // in the blend space
};

/// Asks a scene through its camera.
class Prober
{
public:
    explicit Prober(const PaintingScene &scene)
        : mScene(scene), solid(*PaintingSolid::make(scene.painting, scene.moment, {}))
    {
    }

    Probe towards(const Vec3 &target) const { return along(target - mScene.camera.eye); }

    Probe along(Vec3 ray) const
    {
        ray /= (mScene.camera.rotation.conjugate() * ray).z() * -1; // depth grows by 1
        std::vector<SubstratePoint> points;
        solid.surfaces(mScene.camera.eye, ray, 0, points);
        if (points.empty())
            return {};
        return {points[0], solid.colour(points[0], &ray)};
    }

private:
    PaintingScene mScene;

public:
    PaintingSolid solid;
};

inline Eigen::Vector3d encoded(float r, float g, float b)
{
    return encodedFromLinear(Eigen::Vector3d(r, g, b));
}

// As in painting_scenes.cpp.
inline const Eigen::Vector3d paper = encoded(0.85f, 0.8f, 0.7f), blue = encoded(0.1f, 0.25f, 0.8f),
                             red = encoded(0.8f, 0.08f, 0.05f), green = encoded(0.1f, 0.55f, 0.15f),
                             yellow = encoded(0.95f, 0.75f, 0.1f);

inline bool near(const Eigen::Vector3d &a, const Eigen::Vector3d &b, double tolerance = 1e-6)
{
    return (a - b).cwiseAbs().maxCoeff() <= tolerance;
}

inline bool isRed(const Probe &probe)
{
    return probe.point && near(probe.colour, red);
}

inline ReferenceFrame frameOf(const PaintingScene &scene, int width = 160)
{
    ReferenceOptions options;
    options.width = width;
    options.height = width * 3 / 4;
    options.moment = scene.moment;
    return *referenceFrame(scene.painting, scene.camera, options, {});
}

} // namespace ductus
