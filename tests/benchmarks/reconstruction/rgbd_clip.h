// The frames of a 7-Scenes sequence [Shotton et al. 2013]: a static room filmed with a Kinect, with the
// camera's pose and the depth of every frame. Other people's data; it is not part of the project.
#pragma once

#include "benchmarks/reconstruction/scene_truth.h"
#include "doodling/clip/clip.h"

#include <filesystem>
#include <memory>

namespace ductus {

class RgbdClip : public Clip
{
public:
    /// Null where the folder is absent. At most \a mostFrames, every \a step th one.
    static std::unique_ptr<RgbdClip> open(const std::filesystem::path &folder, int mostFrames, int step);

    const ClipInfo &info() const override { return mPictures->info(); }
    Result<Image> frame(int index, int mostLines) override { return mPictures->frame(index, mostLines); }

    /// As told by the sequence; the focal length is not.
    std::vector<ShotCamera> cameras() const;
    /// Every \a stride th pixel of \a frame where the sensor measured, beside what \a shot says.
    std::vector<DepthPair> depths(const Shot &shot, int frame, int stride) const;

private:
    std::filesystem::path mFolder;
    std::vector<int> mNumbers; // of the frames
    std::unique_ptr<Clip> mPictures;
};

} // namespace ductus
