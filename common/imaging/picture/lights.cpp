#include "imaging/picture/lights.h"

#include <cmath>
#include <numbers>

namespace ductus::picture {

namespace {

constexpr int skyLamps = 52;
constexpr int keyLamps = 14;
constexpr double keyConeDegrees = 9.0; // half angle: how soft the edges of shadows are
constexpr double radiansPerDegree = std::numbers::pi / 180.0;
const double goldenAngle = std::numbers::pi * (3.0 - std::sqrt(5.0));

Vec3 fromAngles(double azimuthDegrees, double elevationDegrees)
{
    const double azimuth = azimuthDegrees * radiansPerDegree;
    const double elevation = elevationDegrees * radiansPerDegree;
    return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
            std::cos(azimuth) * std::cos(elevation)};
}

// A spiral of evenly spread directions over the upper half of the sphere (Fibonacci lattice).
std::vector<Lamp> skyDome()
{
    std::vector<Lamp> lamps;
    double horizontal = 0.0;
    for (int i = 0; i < skyLamps; ++i) {
        const double height = (i + 0.5) / skyLamps;
        const double round = std::sqrt(1.0 - height * height);
        const Vec3 towards(round * std::cos(i * goldenAngle), height, round * std::sin(i * goldenAngle));
        lamps.push_back({towards, 0.55 + 0.45 * height}); // brighter overhead
        horizontal += lamps.back().strength * height;
    }
    for (Lamp &lamp : lamps)
        lamp.strength /= horizontal;
    return lamps;
}

std::vector<Lamp> keyCone(const Vec3 &middle)
{
    const Vec3 side = middle.cross(Vec3::UnitY()).normalized();
    const Vec3 above = side.cross(middle);
    const double spread = std::tan(keyConeDegrees * radiansPerDegree);
    std::vector<Lamp> lamps;
    double facing = 0.0;
    for (int i = 0; i < keyLamps; ++i) {
        const double r = spread * std::sqrt((i + 0.5) / keyLamps);
        const double angle = i * goldenAngle;
        lamps.push_back(
            {(middle + r * std::cos(angle) * side + r * std::sin(angle) * above).normalized(), 1.0});
        facing += lamps.back().towards.dot(middle);
    }
    for (Lamp &lamp : lamps)
        lamp.strength /= facing;
    return lamps;
}

} // namespace

Lights studioLights(double cameraAzimuthDegrees)
{
    Lights lights;
    lights.sky = skyDome();
    lights.towardsKey = fromAngles(cameraAzimuthDegrees - 48.0, 52.0);
    lights.key = keyCone(lights.towardsKey);
    lights.towardsFill = fromAngles(cameraAzimuthDegrees + 65.0, 15.0);
    return lights;
}

} // namespace ductus::picture
