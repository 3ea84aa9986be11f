#include "doodling/clip/frame_picture.h"
#include "doodling/clip/open_clip.h"
#include "doodling/clip/video_stream.h"

#include <algorithm>

namespace ductus {

namespace {

constexpr double picturesPerSecond = 24.0; // pictures do not say; the rate of film

class PictureFolder : public Clip
{
public:
    PictureFolder(std::vector<std::filesystem::path> files, ClipInfo info)
        : mFiles(std::move(files)), mInfo(std::move(info))
    {
    }

    const ClipInfo &info() const override { return mInfo; }

    Result<Image> frame(int index, int mostLines) override
    {
        const std::filesystem::path &file = mFiles.at(std::size_t(index));
        const Error broken{ErrorCode::ReadFailed, "Reading the clip", "this picture cannot be decoded",
                           "Replace or remove it", file.string()};
        Result<VideoStream> video = VideoStream::open(file);
        if (!video)
            return broken;
        const AVFrame *decoded = video->next();
        if (!decoded)
            return broken;
        Result<Image> picture = mPicture.make(*decoded, video->rotationDegrees(), mostLines);
        const auto size = scaledSize(mInfo.width, mInfo.height, mostLines);
        if (picture && std::pair(picture->width, picture->height) != size)
            return Error{ErrorCode::Malformed, "Reading the clip",
                         "this picture has another size than the first one",
                         "Give all pictures of a clip the same size", file.string()};
        return picture;
    }

private:
    std::vector<std::filesystem::path> mFiles;
    ClipInfo mInfo;
    FramePicture mPicture;
};

} // namespace

bool isBeforeInNameOrder(const std::filesystem::path &left, const std::filesystem::path &right)
{
    const std::string a = left.filename().string(), b = right.filename().string();
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    std::size_t i = 0, j = 0;
    while (i < a.size() && j < b.size()) {
        if (isDigit(a[i]) && isDigit(b[j])) {
            const auto endOf = [&](const std::string &s, std::size_t k) {
                while (k < s.size() && isDigit(s[k]))
                    ++k;
                return k;
            };
            const std::size_t endA = endOf(a, i), endB = endOf(b, j);
            while (i + 1 < endA && a[i] == '0')
                ++i;
            while (j + 1 < endB && b[j] == '0')
                ++j;
            if (endA - i != endB - j)
                return endA - i < endB - j;
            for (; i < endA; ++i, ++j)
                if (a[i] != b[j])
                    return a[i] < b[j];
            continue;
        }
        if (a[i] != b[j])
            return a[i] < b[j];
        ++i;
        ++j;
    }
    return a.size() - i != b.size() - j ? a.size() - i < b.size() - j : a < b;
}

bool isPictureFile(const std::filesystem::path &path)
{
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return ending == ".jpg" || ending == ".jpeg" || ending == ".png" || ending == ".bmp" ||
           ending == ".tif" || ending == ".tiff" || ending == ".webp";
}

Result<std::unique_ptr<Clip>> openPictureFolder(const std::filesystem::path &path, const JobControl &)
{
    std::error_code failure;
    std::vector<std::filesystem::path> files;
    for (const auto &entry : std::filesystem::directory_iterator(path, failure))
        if (isPictureFile(entry.path()))
            files.push_back(entry.path());
    if (failure)
        return Error{ErrorCode::PermissionDenied, "Opening the clip", failure.message(),
                     "Choose a folder you may read", path.string()};
    if (files.empty())
        return Error{ErrorCode::Unsupported, "Opening the clip", "there are no pictures in this folder",
                     "Choose a video, or a folder of JPEG or PNG pictures", path.string()};
    std::sort(files.begin(), files.end(), isBeforeInNameOrder);
    Result<VideoStream> first = VideoStream::open(files.front());
    if (!first)
        return first.error();
    ClipInfo info;
    info.frameCount = int(files.size());
    const AVCodecParameters &codec = *first->stream().codecpar;
    const bool isSideways = first->rotationDegrees() % 180 != 0;
    info.width = isSideways ? codec.height : codec.width;
    info.height = isSideways ? codec.width : codec.height;
    info.framesPerSecond = picturesPerSecond;
    for (int i = 0; i < info.frameCount; ++i)
        info.frameTimes.push_back(i / picturesPerSecond);
    info.codec = avcodec_get_name(codec.codec_id);
    return std::unique_ptr<Clip>(std::make_unique<PictureFolder>(std::move(files), std::move(info)));
}

Result<std::unique_ptr<Clip>> openClip(const std::filesystem::path &path, const JobControl &control)
{
    std::error_code failure;
    const auto status = std::filesystem::status(path, failure);
    if (!std::filesystem::exists(status))
        return Error{ErrorCode::FileNotFound, "Opening the clip", "there is no such file",
                     "Choose another one", path.string()};
    return std::filesystem::is_directory(status) ? openPictureFolder(path, control)
                                                 : openVideo(path, control);
}

} // namespace ductus
