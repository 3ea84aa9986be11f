#include "benchmarks/reconstruction/rgbd_clip.h"

#include "benchmarks/reconstruction/depth_png.h"

#include <algorithm>
#include <cstdio>
#include <fstream>

namespace ductus {

namespace {

constexpr int millimetresNowhere = 65535;
constexpr int nearestMillimetres = 100; // less is no measurement

std::filesystem::path fileOf(const std::filesystem::path &folder, int number, const char *ending)
{
    char name[48];
    std::snprintf(name, sizeof name, "frame-%06d.%s", number, ending);
    return folder / name;
}

// The colour pictures of a folder whose others are depth: every second one, thinned.
class ColourPictures : public Clip
{
public:
    ColourPictures(std::unique_ptr<Clip> all, std::vector<int> numbers)
        : mAll(std::move(all)), mNumbers(std::move(numbers)), mInfo(mAll->info())
    {
        mInfo.frameCount = int(mNumbers.size());
        mInfo.frameTimes.resize(mNumbers.size());
    }
    const ClipInfo &info() const override { return mInfo; }
    Result<Image> frame(int index, int mostLines) override
    {
        return mAll->frame(2 * mNumbers[std::size_t(index)], mostLines);
    }

private:
    std::unique_ptr<Clip> mAll;
    std::vector<int> mNumbers;
    ClipInfo mInfo;
};

} // namespace

std::unique_ptr<RgbdClip> RgbdClip::open(const std::filesystem::path &folder, int mostFrames, int step)
{
    std::error_code failure;
    if (!std::filesystem::is_directory(folder, failure))
        return nullptr;
    auto clip = std::make_unique<RgbdClip>();
    clip->mFolder = folder;
    for (int number = 0; int(clip->mNumbers.size()) < mostFrames; number += step) {
        if (!std::filesystem::exists(fileOf(folder, number, "color.jpg"), failure))
            break;
        clip->mNumbers.push_back(number);
    }
    Result<std::unique_ptr<Clip>> all = openClip(folder, {});
    if (!all || clip->mNumbers.empty())
        return nullptr;
    clip->mPictures = std::make_unique<ColourPictures>(std::move(*all), clip->mNumbers);
    return clip;
}

std::vector<ShotCamera> RgbdClip::cameras() const
{
    std::vector<ShotCamera> cameras;
    for (int number : mNumbers) {
        std::ifstream file(fileOf(mFolder, number, "pose.txt"));
        ShotCamera camera;
        for (int i = 0; i < 16; ++i) {
            double value = 0.0;
            file >> value;
            camera.worldFromCamera.matrix()(i / 4, i % 4) = value;
        }
        cameras.push_back(camera);
    }
    return cameras;
}

std::vector<DepthPair> RgbdClip::depths(const Shot &shot, int frame, int stride) const
{
    const DepthPicture real = readDepthPng(fileOf(mFolder, mNumbers[std::size_t(frame)], "depth.png"));
    std::vector<DepthPair> pairs;
    for (int y = stride / 2; y < real.height; y += stride)
        for (int x = stride / 2; x < real.width; x += stride) {
            const int millimetres = real.values[std::size_t(y) * std::size_t(real.width) + std::size_t(x)];
            if (millimetres < nearestMillimetres || millimetres == millimetresNowhere)
                continue;
            const Vec2 pixel((x + 0.5) * shot.width / real.width, (y + 0.5) * shot.height / real.height);
            pairs.push_back({shot.depthAt(frame, pixel), 0.001 * millimetres});
        }
    return pairs;
}

} // namespace ductus
