#include "doodling/reconstruction/given/given_cameras.h"
#include "formats/text/number_text.h"
#include "formats/text/text_lines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace ductus {

namespace {

struct Lens
{
    double width = 0.0, height = 0.0, focalX = 0.0, focalY = 0.0;
    Vec2 centre = Vec2::Zero();
    bool isDistorted = false;
};

struct Photo
{
    std::string name;
    std::string lens;
    Eigen::Isometry3d cameraFromWorld = Eigen::Isometry3d::Identity();
};

Error wrong(const std::string &place, const std::string &problem)
{
    return {ErrorCode::Malformed, "Reading the cameras", problem,
            "Write COLMAP's model again: colmap model_converter --output_type TXT", place};
}

std::vector<std::string> wordsOf(const std::string &line)
{
    std::vector<std::string> words;
    Words rest(line);
    for (std::string_view word = rest.next(); !word.empty(); word = rest.next())
        words.emplace_back(word);
    return words;
}

// Numbers from words[first] on; nothing if one is none.
std::optional<std::vector<double>> numbersOf(const std::vector<std::string> &words, std::size_t first,
                                             std::size_t count)
{
    std::vector<double> numbers;
    for (std::size_t i = first; i < first + count; ++i) {
        double number = 0.0;
        if (i >= words.size() || readNumber(words[i], number) != NumberFault::None)
            return std::nullopt;
        numbers.push_back(number);
    }
    return numbers;
}

// Lines of \a text that are no remarks, with their numbers.
std::vector<std::pair<int, std::string>> linesOf(std::string_view text)
{
    std::vector<std::pair<int, std::string>> lines;
    std::istringstream stream{std::string(text)};
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
        if (!line.empty() && line.back() == '\r')
            line.pop_back();
        if (line.empty() || line.front() != '#')
            lines.emplace_back(number, std::move(line));
    }
    return lines;
}

// CAMERA_ID MODEL WIDTH HEIGHT PARAMS...
Result<std::map<std::string, Lens>> lensesOf(std::string_view text, const std::string &name)
{
    std::map<std::string, Lens> lenses;
    for (const auto &[number, line] : linesOf(text)) {
        const std::vector<std::string> words = wordsOf(line);
        if (words.empty())
            continue;
        const std::string place = name + "/cameras.txt:" + std::to_string(number);
        const bool hasTwo =
            words.size() > 1 && (words[1] == "PINHOLE" || words[1] == "OPENCV" || words[1] == "FULL_OPENCV");
        const bool hasOne = words.size() > 1 && (words[1] == "SIMPLE_PINHOLE" ||
                                                 words[1] == "SIMPLE_RADIAL" || words[1] == "RADIAL");
        if (!hasOne && !hasTwo)
            return Error{ErrorCode::Unsupported, "Reading the cameras",
                         "the lens is of a kind that is not known here",
                         "Use one of SIMPLE_PINHOLE, PINHOLE, SIMPLE_RADIAL, RADIAL, OPENCV", place};
        const auto values = numbersOf(words, 2, hasTwo ? 6 : 5);
        if (!values || !((*values)[0] >= 1.0) || !((*values)[1] >= 1.0) || !((*values)[2] > 0.0))
            return wrong(place, "a number is missing or wrong");
        const std::vector<double> &v = *values;
        Lens lens{v[0], v[1], v[2], hasTwo ? v[3] : v[2], {v[v.size() - 2], v.back()}, false};
        for (std::size_t i = 2 + v.size(); i < words.size(); ++i) {
            const auto distortion = numbersOf(words, i, 1);
            lens.isDistorted = lens.isDistorted || (distortion && std::abs((*distortion)[0]) > 1e-3);
        }
        lenses[words[0]] = lens;
    }
    return lenses;
}

// Two lines a photo: IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME, and its points, which may be empty.
Result<std::vector<Photo>> photosOf(std::string_view text, const std::string &name)
{
    std::vector<Photo> photos;
    const auto lines = linesOf(text);
    for (std::size_t i = 0; i < lines.size(); i += 2) {
        const std::vector<std::string> words = wordsOf(lines[i].second);
        if (words.empty() && i + 1 >= lines.size())
            break;
        const std::string place = name + "/images.txt:" + std::to_string(lines[i].first);
        const auto numbers = numbersOf(words, 1, 7);
        if (!numbers || words.size() < 10)
            return wrong(place, "this is no line of a photo");
        const Eigen::Quaterniond turn((*numbers)[0], (*numbers)[1], (*numbers)[2], (*numbers)[3]);
        if (!(turn.norm() > 1e-6))
            return wrong(place, "the rotation is none");
        Photo photo;
        photo.lens = words[8];
        photo.name = words[9];
        photo.cameraFromWorld.linear() = turn.normalized().toRotationMatrix();
        photo.cameraFromWorld.translation() = Vec3((*numbers)[4], (*numbers)[5], (*numbers)[6]);
        photos.push_back(std::move(photo));
    }
    std::sort(photos.begin(), photos.end(), [](const Photo &a, const Photo &b) { return a.name < b.name; });
    return photos;
}

} // namespace

Result<GivenCameras> parseColmap(std::string_view camerasText, std::string_view imagesText,
                                 const std::string &name, int frameCount, int clipWidth, int clipHeight)
{
    const Result<std::map<std::string, Lens>> lenses = lensesOf(camerasText, name);
    if (!lenses)
        return lenses.error();
    const Result<std::vector<Photo>> photos = photosOf(imagesText, name);
    if (!photos)
        return photos.error();
    if (int(photos->size()) != frameCount)
        return Error{ErrorCode::TooLittleData, "Reading the cameras",
                     "there are " + std::to_string(photos->size()) + " photos in it and the clip has " +
                         std::to_string(frameCount) + " frames",
                     "Register every frame, or give the cameras as JSON with the frames' numbers",
                     name + "/images.txt"};
    GivenCameras given;
    bool isDistorted = false, isStretched = false;
    for (const Photo &photo : *photos) {
        const auto lens = lenses->find(photo.lens);
        if (lens == lenses->end())
            return wrong(name + "/images.txt",
                         "the photo " + photo.name + " has a lens that is not in cameras.txt");
        const double scale = clipWidth / lens->second.width;
        if (std::abs(lens->second.height * scale - clipHeight) > 0.02 * clipHeight + 1.0)
            return wrong(name + "/cameras.txt", "the photos have another shape than the clip");
        isDistorted = isDistorted || lens->second.isDistorted;
        isStretched =
            isStretched || std::abs(lens->second.focalX - lens->second.focalY) > 0.01 * lens->second.focalX;
        ShotCamera camera;
        camera.worldFromCamera = photo.cameraFromWorld.inverse();
        camera.focal = 0.5 * (lens->second.focalX + lens->second.focalY) * scale;
        camera.centre = lens->second.centre * scale;
        given.cameras.push_back(camera);
    }
    if (isDistorted)
        given.warnings.push_back("The lens' distortion is left out; undistorted photos give better results.");
    if (isStretched)
        given.warnings.push_back("The lens has two focal lengths; their mean is taken.");
    return given;
}

} // namespace ductus
