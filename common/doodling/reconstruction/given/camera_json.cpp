#include "doodling/reconstruction/given/given_cameras.h"
#include "doodling/scene/camera_numbers.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace ductus {

namespace {

using Json = nlohmann::json;

class CameraJsonReader
{
public:
    CameraJsonReader(const std::string &name, int frameCount, int clipWidth, int clipHeight)
        : mName(name), mCameras(std::size_t(std::max(0, frameCount))), mClipWidth(clipWidth),
          mClipHeight(clipHeight)
    {
    }

    Result<GivenCameras> read(const Json &root)
    {
        if (!root.is_object() || !root.contains("cameras") || !root["cameras"].is_array())
            return wrong("cameras", "is missing or no list");
        const Result<std::vector<double>> size = numbers(root, "width", 1, "");
        const Result<std::vector<double>> lines = numbers(root, "height", 1, "");
        for (const auto *value : {&size, &lines})
            if (!*value)
                return value->error();
        if (!((*size)[0] >= 1.0) || !((*lines)[0] >= 1.0))
            return wrong("width", "is no size of a picture");
        mScale = mClipWidth / (*size)[0];
        if (std::abs((*lines)[0] * mScale - mClipHeight) > 0.02 * mClipHeight + 1.0)
            return wrong("height", "the picture has another shape than the clip (" +
                                       std::to_string(mClipWidth) + " x " + std::to_string(mClipHeight) +
                                       ")");
        for (std::size_t i = 0; i < root["cameras"].size(); ++i)
            if (Result<void> read = readCamera(root["cameras"][i], "cameras/" + std::to_string(i)); !read)
                return read.error();
        return filled();
    }

private:
    Error wrong(const std::string &place, const std::string &problem) const
    {
        return {ErrorCode::Malformed, "Reading the cameras", problem,
                "See `doodlestudio analyse` in the manual for the form of this file", mName + ": " + place};
    }

    Result<std::vector<double>> numbers(const Json &object, const char *key, std::size_t count,
                                        const std::string &place) const
    {
        std::vector<double> values;
        if (object.contains(key)) {
            const Json &value = object[key];
            if (count == 1 && value.is_number())
                values.push_back(value.get<double>());
            else if (count > 1 && value.is_array() && value.size() == count)
                for (const Json &one : value)
                    if (one.is_number())
                        values.push_back(one.get<double>());
        }
        for (double value : values)
            if (!std::isfinite(value))
                values.clear();
        if (values.size() != count)
            return wrong(place + key, "is missing or not " +
                                          (count == 1 ? "a number" : std::to_string(count) + " numbers"));
        return values;
    }

    Result<void> readCamera(const Json &object, const std::string &place)
    {
        if (!object.is_object())
            return wrong(place, "is no object");
        const auto frame = numbers(object, "frame", 1, place + "/"),
                   position = numbers(object, "position", 3, place + "/"),
                   rotation = numbers(object, "rotation", 4, place + "/"),
                   focal = numbers(object, "focal", 1, place + "/");
        for (const auto *value : {&frame, &position, &rotation, &focal})
            if (!*value)
                return value->error();
        std::vector<double> centre{0.5 * mClipWidth / mScale, 0.5 * mClipHeight / mScale};
        if (object.contains("centre")) {
            const auto given = numbers(object, "centre", 2, place + "/");
            if (!given)
                return given.error();
            centre = *given;
        }
        const double t = (*frame)[0];
        if (t != std::floor(t) || t < 0.0 || t >= double(mCameras.size()))
            return wrong(place + "/frame", "is no frame of the clip");
        const Eigen::Quaterniond turn((*rotation)[3], (*rotation)[0], (*rotation)[1], (*rotation)[2]);
        if (!(turn.norm() > 1e-6))
            return wrong(place + "/rotation", "is no rotation");
        const Eigen::Quaterniond unit = turn.normalized();
        const std::array<double, numbersACamera> all{
            unit.x(),           unit.y(),          unit.z(),       unit.w(),
            (*position)[0],     (*position)[1],    (*position)[2], (*focal)[0] * mScale,
            centre[0] * mScale, centre[1] * mScale};
        const std::optional<ShotCamera> camera = cameraOf(all);
        if (!camera)
            return wrong(place + "/focal", "is no focal length");
        mCameras[std::size_t(t)] = *camera;
        return {};
    }

    // What is missing between two frames is put in between; beyond the ends the camera stays.
    Result<GivenCameras> filled() const
    {
        std::vector<std::size_t> known;
        for (std::size_t t = 0; t < mCameras.size(); ++t)
            if (mCameras[t])
                known.push_back(t);
        if (known.empty())
            return Error{ErrorCode::TooLittleData, "Reading the cameras", "there is no camera in it",
                         "Give at least one camera, better one for every frame", mName};
        GivenCameras given;
        std::size_t after = 0;
        for (std::size_t t = 0; t < mCameras.size(); ++t) {
            while (after + 1 < known.size() && known[after] < t)
                ++after;
            const std::size_t before = after > 0 && known[after] > t ? after - 1 : after;
            const ShotCamera &a = *mCameras[known[before]], &b = *mCameras[known[after]];
            const double gap = double(known[after]) - double(known[before]);
            const double share = gap > 0.0 ? (double(t) - double(known[before])) / gap : 0.0;
            given.cameras.push_back(between(a, b, share));
        }
        if (known.size() < mCameras.size())
            given.warnings.push_back("The cameras file has " + std::to_string(known.size()) + " of " +
                                     std::to_string(mCameras.size()) +
                                     " frames; the others are put in between.");
        return given;
    }

    static ShotCamera between(const ShotCamera &a, const ShotCamera &b, double share)
    {
        if (share <= 0.0)
            return a;
        ShotCamera camera = a;
        const Eigen::Quaterniond from(a.worldFromCamera.linear()), to(b.worldFromCamera.linear());
        camera.worldFromCamera.linear() = from.slerp(share, to).normalized().toRotationMatrix();
        camera.worldFromCamera.translation() = (1.0 - share) * a.position() + share * b.position();
        camera.focal = (1.0 - share) * a.focal + share * b.focal;
        camera.centre = (1.0 - share) * a.centre + share * b.centre;
        return camera;
    }

    std::string mName;
    std::vector<std::optional<ShotCamera>> mCameras;
    int mClipWidth, mClipHeight;
    double mScale = 1.0;
};

} // namespace

Result<GivenCameras> parseCameraJson(std::string_view text, const std::string &name, int frameCount,
                                     int clipWidth, int clipHeight)
{
    const Json root = Json::parse(text, nullptr, false);
    if (root.is_discarded())
        return Error{ErrorCode::Malformed, "Reading the cameras", "it is no JSON",
                     "See `doodlestudio analyse` in the manual for the form of this file", name};
    return CameraJsonReader(name, frameCount, clipWidth, clipHeight).read(root);
}

} // namespace ductus
