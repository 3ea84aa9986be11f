#include "imaging/surface_picture.h"

#include "base/parallel.h"
#include "imaging/picture/colour.h"
#include "imaging/picture/ground.h"
#include "imaging/picture/shading.h"
#include "imaging/picture/visibility.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ductus {

namespace {

using namespace picture;

constexpr double creaseOpacity = 0.72;
constexpr double hiddenOpacity = 0.16;
constexpr double groundShadowStrength = 0.78;

PictureOptions clamped(PictureOptions options)
{
    const auto within = [](double x, double low, double high, double otherwise) {
        return std::isfinite(x) ? std::clamp(x, low, high) : otherwise;
    };
    options.width = std::clamp(options.width, 1, 16384);
    options.height = std::clamp(options.height, 1, 16384);
    options.azimuthDegrees =
        std::isfinite(options.azimuthDegrees) ? std::fmod(options.azimuthDegrees, 360.0) : 35.0;
    options.elevationDegrees = within(options.elevationDegrees, -90.0, 90.0, 25.0);
    options.fieldOfViewDegrees = within(options.fieldOfViewDegrees, 1.0, 120.0, 26.0);
    options.margin = within(options.margin, 0.0, 0.45, 0.08);
    options.supersampling = std::clamp(options.supersampling, 1, 4);
    return options;
}

// Draws the tiles; one object for one picture.
class Painter
{
public:
    Painter(const Stage &stage, const PictureOptions &options)
        : mStage(stage), mOptions(options), mCamera(framedCamera(stage, options)),
          mVisibility(stage, mCamera, options.width, options.height, options.supersampling),
          mShading(stage, options.azimuthDegrees, options.softLight),
          mTop(linearFromRgba(options.backgroundTop)), mBottom(linearFromRgba(options.backgroundBottom))
    {
        // From below the ground it would hide the object.
        if (options.groundShadow && mCamera.eyeInStage.y() > stage.groundHeight)
            mGround.emplace(stage, mShading.lights());
    }

    Image paint() const
    {
        Image image(mOptions.width, mOptions.height);
        const auto columns = std::size_t(mVisibility.tileColumns());
        parallelFor(0, columns * std::size_t(mVisibility.tileRows()),
                    [&](std::size_t tile) { paintTile(int(tile % columns), int(tile / columns), image); });
        return image;
    }

private:
    // The exposure of a place of this pixel, which other samples of it on the same surface may use, too.
    struct SharedExposure
    {
        Vec3 normal;
        double depth;
        Exposure exposure;
    };

    void paintTile(int column, int row, Image &image) const;
    Vec3 sampleColour(const Sample &sample, double x, double y, std::vector<SharedExposure> &shared) const;
    Vec3 surfaceColour(const Sample &sample, double x, double y, std::vector<SharedExposure> &shared) const;
    Vec3 tubeColour(int tube, const Vec3 &ray) const;
    Vec3 backgroundColour(double x, double y) const;

    const Stage &mStage;
    const PictureOptions &mOptions;
    Camera mCamera;
    Visibility mVisibility;
    Shading mShading;
    std::optional<Ground> mGround;
    Vec3 mTop, mBottom; // of the background, linear
};

void Painter::paintTile(int column, int row, Image &image) const
{
    std::vector<Sample> samples;
    mVisibility.traceTile(column, row, samples);
    const int side = mVisibility.tileSamples();
    const int fine = mOptions.supersampling;
    std::vector<SharedExposure> shared;
    for (int y = 0; y < Visibility::tilePixels; ++y) {
        for (int x = 0; x < Visibility::tilePixels; ++x) {
            const int px = column * Visibility::tilePixels + x;
            const int py = row * Visibility::tilePixels + y;
            if (px >= image.width || py >= image.height)
                continue;
            shared.clear();
            Vec3 sum = Vec3::Zero();
            for (int j = y * fine; j < (y + 1) * fine; ++j) {
                for (int i = x * fine; i < (x + 1) * fine; ++i)
                    sum += sampleColour(samples[std::size_t(j) * std::size_t(side) + std::size_t(i)],
                                        column * side + i + 0.5, row * side + j + 0.5, shared);
            }
            image.set(px, py, rgbaFromLinear(sum / double(fine * fine)));
        }
    }
}

Vec3 Painter::sampleColour(const Sample &sample, double x, double y,
                           std::vector<SharedExposure> &shared) const
{
    const auto behind = [&] {
        Vec3 colour = sample.triangle >= 0 ? surfaceColour(sample, x, y, shared) : backgroundColour(x, y);
        if (sample.hiddenTube >= 0) {
            const Vec3 &albedo = mStage.tubes[std::size_t(sample.hiddenTube)].albedo;
            colour += hiddenOpacity * (albedo - colour);
        }
        return colour;
    };
    if (sample.tube < 0)
        return behind();
    const StageTube &tube = mStage.tubes[std::size_t(sample.tube)];
    if (!tube.isCrease)
        return tubeColour(sample.tube, mCamera.ray(x, y));
    const Vec3 colour = behind();
    return colour + creaseOpacity * (tube.albedo - colour);
}

Vec3 Painter::surfaceColour(const Sample &sample, double x, double y,
                            std::vector<SharedExposure> &shared) const
{
    const StageTriangle &triangle = mStage.triangles[std::size_t(sample.triangle)];
    const Vec3 weights = mVisibility.barycentric(sample.triangle, x, y);
    const Vec3 ray = mCamera.ray(x, y);
    const Vec3 point = mCamera.toStage(ray * double(sample.surfaceDepth));
    const Vec3 towardsEye = (mCamera.eyeInStage - point).normalized();
    // Both sides of an open surface are clay: the normals turn to the one that is seen.
    const double facing = triangle.faceNormal.dot(towardsEye) < 0.0 ? -1.0 : 1.0;
    const Vec3 faceNormal = facing * triangle.faceNormal;
    Vec3 normal = facing * (weights[0] * triangle.normals[0] + weights[1] * triangle.normals[1] +
                            weights[2] * triangle.normals[2]);
    normal = normal.norm() > 1e-6 ? Vec3(normal.normalized()) : faceNormal;
    const Vec3 albedo =
        weights[0] * triangle.albedo[0] + weights[1] * triangle.albedo[1] + weights[2] * triangle.albedo[2];

    for (const SharedExposure &known : shared) {
        if (std::abs(known.depth - double(sample.surfaceDepth)) < 0.01 && known.normal.dot(normal) > 0.98)
            return mShading.surfaceColour(albedo, normal, towardsEye, known.exposure);
    }
    const Exposure exposure =
        mOptions.softLight ? mShading.exposure(point, normal, faceNormal) : mShading.freeExposure(normal);
    shared.push_back({normal, double(sample.surfaceDepth), exposure});
    return mShading.surfaceColour(albedo, normal, towardsEye, exposure);
}

Vec3 Painter::tubeColour(int tube, const Vec3 &ray) const
{
    TubeHit hit;
    hitTube(mVisibility.tubeEnd(tube, 0), mVisibility.tubeEnd(tube, 1), mVisibility.drawnRadius(tube), ray,
            hit);
    const Vec3 normal = mCamera.eyeFromStage.transpose() * hit.normal;
    const Vec3 towardsEye = -(mCamera.eyeFromStage.transpose() * ray).normalized();
    return mShading.surfaceColour(mStage.tubes[std::size_t(tube)].albedo, normal, towardsEye,
                                  mShading.freeExposure(normal));
}

Vec3 Painter::backgroundColour(double x, double y) const
{
    const double down = std::clamp(y / (2.0 * mCamera.centreY), 0.0, 1.0);
    // Blended by a smooth step: no visible horizon.
    const Vec3 colour = mTop + down * down * (3.0 - 2.0 * down) * (mBottom - mTop);
    if (!mGround)
        return colour;
    const Vec3 ray = mCamera.eyeFromStage.transpose() * mCamera.ray(x, y);
    if (ray.y() > -1e-6)
        return colour;
    const double t = (mGround->height() - mCamera.eyeInStage.y()) / ray.y();
    const Vec3 place = mCamera.eyeInStage + t * ray;
    return colour * (1.0 - groundShadowStrength * mGround->shadow(place.x(), place.z()));
}

} // namespace

Image renderPicture(const PictureScene &scene, const PictureOptions &options)
{
    const PictureOptions checked = clamped(options);
    const Stage stage = makeStage(scene, checked.zUp);
    return Painter(stage, checked).paint();
}

} // namespace ductus
