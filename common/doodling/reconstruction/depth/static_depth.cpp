#include "doodling/reconstruction/depth/static_depth.h"

#include "doodling/reconstruction/cameras/camera_fit.h"
#include "doodling/reconstruction/depth/flow_chains.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ductus {

namespace {

// Frames in one direction until the usual depth shows enough parallax.
int chainLength(const Shot &shot, int frame, int direction, double usualInverseDepth,
                const StaticDepthOptions &options)
{
    const Vec3 start = shot.cameras[std::size_t(frame)].position();
    int length = 0;
    while (length < options.longestChain) {
        const int next = frame + direction * (length + 1);
        if (next < 0 || next >= shot.frameCount())
            break;
        ++length;
        const ShotCamera &camera = shot.cameras[std::size_t(next)];
        if ((camera.position() - start).norm() * camera.focal * usualInverseDepth > options.enoughParallax)
            break;
    }
    return length;
}

} // namespace

StaticDepth staticDepth(const Shot &shot, int frame, double usualInverseDepth,
                        const StaticDepthOptions &options)
{
    std::vector<ChainedPlaces> sightings;
    for (int direction : {-1, 1}) {
        const int length = chainLength(shot, frame, direction, usualInverseDepth, options);
        const int every = std::max(1, length / options.mostSightings);
        for (ChainedPlaces &places : chainedFrom(shot, frame, direction * length, {0.35f, every}))
            sightings.push_back(std::move(places));
    }
    const ShotCamera &camera = shot.cameras[std::size_t(frame)];
    const CompactFlow &grid = shot.forward.front();
    StaticDepth depth;
    std::vector<RaySighting> rays;
    for (std::size_t cell = 0; cell < grid.cellCount(); ++cell) {
        rays.clear();
        for (const ChainedPlaces &places : sightings) {
            if (places.trusts[cell] <= 0.0f)
                continue;
            const int steps = std::abs(places.frame - frame);
            rays.push_back({&shot.cameras[std::size_t(places.frame)], places.pixels[cell].cast<double>(),
                            double(places.trusts[cell]) / (1.0 + 0.1 * steps)});
        }
        const Vec2 pixel = grid.cellMiddle(cell);
        const InverseDepthFit fit =
            rays.empty() ? InverseDepthFit() : fitInverseDepth(camera, pixel, rays, usualInverseDepth, 1.0);
        const bool isKnown = fit.information > 1e-9 && std::isfinite(fit.inverseDepth);
        depth.inverseDepths.push_back(isKnown ? float(fit.inverseDepth) : 0.0f);
        depth.spreads.push_back(isKnown ? float(options.placeSpread / std::sqrt(fit.information))
                                        : std::numeric_limits<float>::infinity());
        depth.misses.push_back(rays.empty() ? -1.0f : float(fit.miss));
    }
    return depth;
}

} // namespace ductus
