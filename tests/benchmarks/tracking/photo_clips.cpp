#include "benchmarks/tracking/photo_clips.h"

#include "base/parallel.h"
#include "doodling/clip/open_clip.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ductus {

namespace {

constexpr int exposures = 3; // a frame
constexpr int inverseSteps = 8;
constexpr double coarseness = 6.0; // limbs side by side on a cut-out's width
constexpr double solid = 0.5;      // alpha from which on it is the thing

// What is low on a cut-out swings, neighbours against each other.
Vec2 swungBy(const CutOut &cutOut, const CutOutPose &pose, const Vec2 &place)
{
    const double low = std::clamp(place.y() / cutOut.picture.height + 0.5, 0.0, 1.0);
    const double across = coarseness * place.x() / cutOut.picture.width;
    return {pose.swing * low * low * std::sin(pose.phase + across), 0.0};
}

Eigen::Matrix2d turned(const CutOutPose &pose)
{
    return pose.size * Eigen::Rotation2Dd(pose.turn).toRotationMatrix();
}

// From the cut-out's middle to the picture, and back.
Vec2 pixelOf(const CutOut &cutOut, const CutOutPose &pose, const Vec2 &place)
{
    return pose.middle + turned(pose) * (place + swungBy(cutOut, pose, place));
}

Vec2 placeOf(const CutOut &cutOut, const CutOutPose &pose, const Vec2 &pixel)
{
    const Vec2 swung = turned(pose).inverse() * (pixel - pose.middle);
    Vec2 place = swung;
    for (int i = 0; i < inverseSteps; ++i)
        place = swung - swungBy(cutOut, pose, place);
    return place;
}

// Red, green, blue, alpha in 0..1 between the cut-out's pixels; nothing outside.
Eigen::Vector4f colourAt(const CutOut &cutOut, const Vec2 &place)
{
    const Image &picture = cutOut.picture;
    const double x = place.x() + 0.5 * picture.width - 0.5, y = place.y() + 0.5 * picture.height - 0.5;
    const int x0 = int(std::floor(x)), y0 = int(std::floor(y));
    Eigen::Vector4f sum = Eigen::Vector4f::Zero();
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            if (x0 + i < 0 || y0 + j < 0 || x0 + i >= picture.width || y0 + j >= picture.height)
                continue;
            const Rgba pixel = picture.at(x0 + i, y0 + j);
            const double share = std::abs(1 - i - (x - x0)) * std::abs(1 - j - (y - y0));
            const float alpha = float(share * pixel[3] / 255.0);
            sum += alpha * Eigen::Vector4f(pixel[0] / 255.0f, pixel[1] / 255.0f, pixel[2] / 255.0f, 1.0f);
        }
    return sum; // colours times alpha
}

class PhotoClip : public Clip
{
public:
    explicit PhotoClip(PhotoScene scene) : mScene(std::move(scene))
    {
        mInfo.frameCount = mScene.frameCount;
        mInfo.width = mScene.background->info().width;
        mInfo.height = mScene.background->info().height;
        mInfo.framesPerSecond = 25.0;
        for (int t = 0; t < mScene.frameCount; ++t)
            mInfo.frameTimes.push_back(t / 25.0);
        mInfo.codec = "photos";
    }
    const ClipInfo &info() const override { return mInfo; }

    Result<Image> frame(int index, int) override
    {
        Result<Image> background = mScene.background->frame(index, 0);
        if (!background)
            return background.error();
        Image image = std::move(*background);
        std::vector<std::vector<CutOutPose>> poses;
        for (const CutOut &cutOut : mScene.cutOuts) {
            poses.emplace_back();
            for (int k = 0; k < exposures; ++k)
                poses.back().push_back(cutOut.pose(index + mScene.exposure * ((k + 0.5) / exposures - 0.5)));
        }
        const float light = float(1.0 + 0.08 * std::sin(0.2 * index));
        parallelFor(0, std::size_t(image.height), [&](std::size_t y) {
            for (int x = 0; x < image.width; ++x)
                image.set(x, int(y),
                          covered(image.at(x, int(y)), poses, Vec2(x + 0.5, double(y) + 0.5), light));
        });
        return image;
    }

private:
    Rgba covered(const Rgba &behind, const std::vector<std::vector<CutOutPose>> &poses, const Vec2 &pixel,
                 float light) const
    {
        Eigen::Vector3f sum = Eigen::Vector3f::Zero();
        for (int k = 0; k < exposures; ++k) {
            Eigen::Vector3f colour(behind[0] / 255.0f, behind[1] / 255.0f, behind[2] / 255.0f);
            for (std::size_t i = 0; i < poses.size(); ++i) {
                const CutOut &cutOut = mScene.cutOuts[i];
                const CutOutPose &pose = poses[i][std::size_t(k)];
                const Eigen::Vector4f front = colourAt(cutOut, placeOf(cutOut, pose, pixel));
                colour = (1.0f - front[3]) * colour + light * front.head<3>();
            }
            sum += colour / float(exposures);
        }
        const auto byte = [&](int i) {
            return std::uint8_t(std::lround(255.0f * std::clamp(sum[i], 0.0f, 1.0f)));
        };
        return {byte(0), byte(1), byte(2), 255};
    }

    PhotoScene mScene;
    ClipInfo mInfo;
};

Result<Image> pictureAt(const std::filesystem::path &folder, int index)
{
    Result<std::unique_ptr<Clip>> clip = openClip(folder, {});
    if (!clip)
        return clip.error();
    return (*clip)->frame(index);
}

// The part of a frame that its mask shows, mirrored if wanted.
Result<Image> cutOutOf(const std::filesystem::path &clip, int index, bool isMirrored)
{
    const Result<Image> frame = pictureAt(clip / "frames", index), mask = pictureAt(clip / "masks", index);
    if (!frame)
        return frame.error();
    if (!mask)
        return mask.error();
    int left = mask->width, right = 0, top = mask->height, bottom = 0;
    for (int y = 0; y < mask->height; ++y)
        for (int x = 0; x < mask->width; ++x)
            if (mask->at(x, y)[0] > 127) {
                left = std::min(left, x);
                right = std::max(right, x + 1);
                top = std::min(top, y);
                bottom = std::max(bottom, y + 1);
            }
    if (right <= left)
        return Error{ErrorCode::Malformed, "Cutting out a thing", "the mask is empty", "", clip.string()};
    Image cut(right - left, bottom - top);
    for (int y = 0; y < cut.height; ++y)
        for (int x = 0; x < cut.width; ++x) {
            const int from = isMirrored ? right - 1 - x : left + x;
            Rgba colour = frame->at(from, top + y);
            colour[3] = mask->at(from, top + y)[0];
            cut.set(x, y, colour);
        }
    return cut;
}

CutOutPose walking(double frame, const Vec2 &from, const Vec2 &step, double swing, double pace)
{
    return {from + frame * step + Vec2(0.0, 0.25 * swing * std::sin(2.0 * pace * frame)),
            0.02 * std::sin(pace * frame), 1.0, swing * std::sin(pace * frame),
            0.7 * std::sin(0.3 * pace * frame)};
}

} // namespace

std::vector<PhotoTrack> photoTracks(const PhotoScene &scene, double spacing)
{
    const CutOut &cutOut = scene.cutOuts.front();
    const Image &picture = cutOut.picture;
    const ClipInfo &size = scene.background->info();
    std::vector<PhotoTrack> tracks;
    for (double y = 0.5 * spacing; y < picture.height; y += spacing)
        for (double x = 0.5 * spacing; x < picture.width; x += spacing) {
            const Vec2 place(x - 0.5 * picture.width, y - 0.5 * picture.height);
            if (colourAt(cutOut, place)[3] < solid)
                continue;
            PhotoTrack track;
            for (int t = 0; t < scene.frameCount; ++t) {
                const Vec2 pixel = pixelOf(cutOut, cutOut.pose(t), place);
                bool isVisible =
                    pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() < size.width && pixel.y() < size.height;
                for (std::size_t i = 1; i < scene.cutOuts.size(); ++i) {
                    const CutOut &other = scene.cutOuts[i];
                    isVisible &= colourAt(other, placeOf(other, other.pose(t), pixel))[3] < solid;
                }
                track.pixels.push_back(pixel);
                track.isVisible.push_back(isVisible);
            }
            tracks.push_back(std::move(track));
        }
    return tracks;
}

std::unique_ptr<Clip> clipOf(const PhotoScene &scene)
{
    return std::make_unique<PhotoClip>(scene);
}

Result<std::vector<PhotoScene>> photoScenes(const std::filesystem::path &data)
{
    const std::filesystem::path davis = data / "clips/davis";
    const Result<Image> camel = cutOutOf(davis / "camel", 20, false),
                        mirrored = cutOutOf(davis / "camel", 60, true),
                        car = cutOutOf(davis / "car-roundabout", 10, false);
    for (const Result<Image> *image : {&camel, &mirrored, &car})
        if (!*image)
            return image->error();
    Result<std::unique_ptr<Clip>> street = openClip(davis / "car-roundabout/frames", {}),
                                  desert = openClip(davis / "camel/frames", {});
    if (!street)
        return street.error();
    if (!desert)
        return desert.error();
    const std::shared_ptr<Clip> road = std::move(*street), sand = std::move(*desert);
    const auto standing = [](const Vec2 &middle, double size) {
        return [=](double) { return CutOutPose{middle, 0.0, size, 0.0, 0.0}; };
    };
    return std::vector<PhotoScene>{{"walk",
                                    48,
                                    0.5,
                                    sand,
                                    {{*mirrored,
                                      [](double t) {
                                          return walking(t, {300, 250}, {3, 0}, 14.0, 0.35);
                                      }}}},
                                   {"run",
                                    28,
                                    0.6,
                                    road,
                                    {{*mirrored,
                                      [](double t) {
                                          return walking(t, {150, 240}, {19, 0.5}, 30.0, 0.8);
                                      }}}},
                                   {"behind",
                                    40,
                                    0.5,
                                    sand,
                                    {{*mirrored,
                                      [](double t) {
                                          return walking(t, {230, 230}, {8, 0}, 12.0, 0.4);
                                      }},
                                     {*car, standing({480, 330}, 0.8)}}},
                                   {"turn", 48, 0.4, road, {{*camel, [](double t) {
                                                                 return CutOutPose{
                                                                     {400 + 60 * std::sin(0.08 * t), 240},
                                                                     0.03 * t,
                                                                     0.6 + 0.014 * t,
                                                                     8.0 * std::sin(0.5 * t),
                                                                     0.0};
                                                             }}}}};
}

} // namespace ductus
