#include "imaging/picture/shading.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ductus::picture {

namespace {

constexpr int skyMapSide = 224; // coarse cells blur the steps between the lamps of the dome
constexpr int keyMapSide = 448;

// Linear RGB of the lamps: a warm key, a cool sky and fill, the ground's bounce.
const Vec3 keyColour(1.00, 0.965, 0.92);
const Vec3 skyColour(0.93, 0.965, 1.0);
const Vec3 groundColour(1.0, 0.985, 0.96);
constexpr double keyPower = 0.72;
constexpr double skyPower = 0.46;
constexpr double fillPower = 0.09;
constexpr double bouncePower = 0.17;

std::vector<ShadowMap> mapsOf(const Stage &stage, const std::vector<Lamp> &lamps, int side)
{
    std::vector<std::optional<ShadowMap>> drawn(lamps.size());
    parallelFor(0, lamps.size(), [&](std::size_t i) { drawn[i].emplace(stage, lamps[i].towards, side); });
    std::vector<ShadowMap> maps;
    maps.reserve(lamps.size());
    for (std::optional<ShadowMap> &map : drawn)
        maps.push_back(std::move(*map));
    return maps;
}

double received(const std::vector<Lamp> &lamps, const std::vector<ShadowMap> &maps, const Vec3 &point,
                const Vec3 &normal, const Vec3 &faceNormal)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < lamps.size(); ++i) {
        const double facing = normal.dot(lamps[i].towards);
        if (facing <= 0.0)
            continue;
        double lit = 1.0;
        if (!maps.empty()) {
            // A cell sees the surface at its own middle, up to a cell away and higher where the surface is
            // steep to the rays. Stepping off along the normal does most; the rest grows with the slope.
            const double cell = maps[i].cellSize();
            const double cosine = std::max(0.15, std::abs(faceNormal.dot(lamps[i].towards)));
            lit = maps[i].lit(point + 1.2 * cell * normal,
                              0.6 * cell * std::sqrt(1.0 - cosine * cosine) / cosine);
        }
        sum += lamps[i].strength * facing * lit;
    }
    return sum;
}

} // namespace

Shading::Shading(const Stage &stage, double cameraAzimuthDegrees, bool castShadows)
    : mLights(studioLights(cameraAzimuthDegrees))
{
    if (castShadows && !stage.triangles.empty()) {
        mSkyMaps = mapsOf(stage, mLights.sky, skyMapSide);
        mKeyMaps = mapsOf(stage, mLights.key, keyMapSide);
    }
}

Exposure Shading::exposure(const Vec3 &point, const Vec3 &normal, const Vec3 &faceNormal) const
{
    return {received(mLights.sky, mSkyMaps, point, normal, faceNormal),
            received(mLights.key, mKeyMaps, point, normal, faceNormal)};
}

Exposure Shading::freeExposure(const Vec3 &normal) const
{
    const double up = 0.5 + 0.5 * normal.y();
    return {up * (0.35 + 0.65 * up), std::max(0.0, normal.dot(mLights.towardsKey))};
}

Vec3 Shading::surfaceColour(const Vec3 &albedo, const Vec3 &normal, const Vec3 &towardsEye,
                            const Exposure &exposure) const
{
    const double fill = std::max(0.0, normal.dot(mLights.towardsFill));
    const double down = 0.5 - 0.5 * normal.y();
    const Vec3 light = keyPower * exposure.key * keyColour + skyPower * exposure.sky * skyColour +
                       fillPower * fill * skyColour + bouncePower * (0.2 + 0.8 * down) * groundColour;
    // A broad soft highlight [Blinn 1977] and a sheen at grazing angles [Schlick 1994] keep clay from looking
    // flat.
    const Vec3 half = (mLights.towardsKey + towardsEye).normalized();
    const double highlight =
        0.055 * std::pow(std::max(0.0, normal.dot(half)), 28.0) * std::min(1.0, exposure.key * 1.5);
    const double grazing = 1.0 - std::clamp(normal.dot(towardsEye), 0.0, 1.0);
    const double sheen = 0.05 * std::pow(grazing, 4.0) * std::min(1.0, exposure.sky);
    return albedo.cwiseProduct(light) + highlight * keyColour + sheen * skyColour;
}

} // namespace ductus::picture
