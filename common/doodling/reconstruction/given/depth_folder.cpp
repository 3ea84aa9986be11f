#include "doodling/reconstruction/given/depth_folder.h"

#include "doodling/clip/open_clip.h"
#include "doodling/clip/video_stream.h"
#include "formats/atomic_file.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace ductus {

namespace {

namespace fs = std::filesystem;

constexpr char attempted[] = "Reading the depth maps";
constexpr std::size_t largestFile = 1u << 30;

std::string endingOf(const fs::path &path)
{
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    return ending;
}

float usable(double depth)
{
    return std::isfinite(depth) && depth > 0.0 && depth < 1e30 ? float(depth) : 0.0f;
}

// The first component of every pixel, of \a bytes each.
template <typename T, typename Value>
GivenDepth planeOf(const AVFrame &frame, int plane, int step, Value value)
{
    GivenDepth depth{frame.width, frame.height, {}};
    depth.depths.reserve(std::size_t(frame.width) * std::size_t(frame.height));
    for (int y = 0; y < frame.height; ++y)
        for (int x = 0; x < frame.width; ++x) {
            T number;
            std::memcpy(&number,
                        frame.data[plane] + std::ptrdiff_t(y) * frame.linesize[plane] +
                            std::ptrdiff_t(x) * step * std::ptrdiff_t(sizeof(T)),
                        sizeof(T));
            depth.depths.push_back(value(number));
        }
    return depth;
}

Result<GivenDepth> decoded(const fs::path &path)
{
    Result<VideoStream> video = VideoStream::open(path);
    if (!video)
        return video.error();
    const AVFrame *frame = video->next();
    if (!frame)
        return Error{ErrorCode::Malformed, attempted, "it cannot be decoded", "Write it again",
                     path.string()};
    const auto whole = [](std::uint16_t v) { return v == 65535 ? 0.0f : float(v); };
    const auto swapped = [&](std::uint16_t v) { return whole(std::uint16_t(v >> 8 | v << 8)); };
    const auto real = [](float v) { return usable(double(v)); };
    switch (frame->format) {
    case AV_PIX_FMT_GRAY16LE:
        return planeOf<std::uint16_t>(*frame, 0, 1, whole);
    case AV_PIX_FMT_GRAY16BE:
        return planeOf<std::uint16_t>(*frame, 0, 1, swapped);
    case AV_PIX_FMT_RGB48LE:
        return planeOf<std::uint16_t>(*frame, 0, 3, whole);
    case AV_PIX_FMT_RGB48BE:
        return planeOf<std::uint16_t>(*frame, 0, 3, swapped);
    case AV_PIX_FMT_GRAYF32LE:
    case AV_PIX_FMT_GBRPF32LE:
    case AV_PIX_FMT_GBRAPF32LE:
        return planeOf<float>(*frame, 0, 1, real);
    default:
        return Error{ErrorCode::Unsupported, attempted,
                     "it is no depth map: its numbers have too few bits or are colours",
                     "Write depth as 16-bit grey PNG, EXR or NPY (float32)", path.string()};
    }
}

// The text after \a key in NumPy's head, which is a Python dictionary; up to the next comma outside of ().
std::string entryOf(std::string_view head, std::string_view key)
{
    const std::size_t at = head.find(key);
    const std::size_t colon = at == std::string_view::npos ? at : head.find(':', at);
    if (colon == std::string_view::npos)
        return {};
    const std::size_t begin = head.find_first_not_of(' ', colon + 1);
    if (begin == std::string_view::npos)
        return {};
    const std::size_t end = head[begin] == '(' ? head.find(')', begin) : head.find_first_of(",}", begin);
    return std::string(head.substr(begin, end == std::string_view::npos ? end : end - begin));
}

} // namespace

Result<GivenDepth> parseNpy(std::string_view bytes, const std::string &name)
{
    const auto wrong = [&](const std::string &problem) {
        return Error{ErrorCode::Malformed, attempted, problem,
                     "Write it with numpy.save: two dimensions, float32, float64 or uint16", name};
    };
    if (bytes.size() < 12 || bytes.substr(0, 6) != std::string_view("\x93NUMPY", 6))
        return wrong("it is no NumPy file");
    const auto byteAt = [&](std::size_t i) { return std::size_t(std::uint8_t(bytes[i])); };
    const bool isLong = byteAt(6) >= 2; // version
    const std::size_t begin = isLong ? 12 : 10;
    const std::size_t length =
        byteAt(8) | byteAt(9) << 8 | (isLong ? byteAt(10) << 16 | byteAt(11) << 24 : 0);
    if (length > bytes.size() - begin)
        return wrong("its head is cut off");
    const std::string_view head = bytes.substr(begin, length), data = bytes.substr(begin + length);
    const std::string kind = entryOf(head, "'descr'"), order = entryOf(head, "'fortran_order'");
    int height = 0, width = 0;
    char rest = 0;
    if (std::sscanf(entryOf(head, "'shape'").c_str(), "(%d, %d%c", &height, &width, &rest) != 2 ||
        height < 1 || width < 1 || height > 32768 || width > 32768)
        return wrong("it has not two dimensions");
    if (order != "False")
        return wrong("its columns come first (fortran_order)");
    const std::size_t count = std::size_t(width) * std::size_t(height);
    GivenDepth depth{width, height, std::vector<float>(count, 0.0f)};
    const auto read = [&]<typename T>(T) -> bool {
        if (data.size() < count * sizeof(T))
            return false;
        for (std::size_t i = 0; i < count; ++i) {
            T number;
            std::memcpy(&number, data.data() + i * sizeof(T), sizeof(T));
            depth.depths[i] =
                std::is_integral_v<T> && double(number) == 65535.0 ? 0.0f : usable(double(number));
        }
        return true;
    };
    const bool isKnown = kind == "'<f4'" || kind == "'<f8'" || kind == "'<u2'";
    if (!isKnown)
        return wrong("its numbers are of a kind that is not known here: " + kind.substr(0, 16));
    const bool isRead = kind == "'<f4'"   ? read(float())
                        : kind == "'<f8'" ? read(double())
                                          : read(std::uint16_t());
    if (!isRead)
        return wrong("it is cut off");
    return depth;
}

Result<std::vector<fs::path>> depthFiles(const fs::path &folder, int frameCount)
{
    std::vector<fs::path> files;
    std::error_code failure;
    for (fs::directory_iterator file(folder, failure), end; !failure && file != end; file.increment(failure))
        if (const std::string ending = endingOf(file->path());
            ending == ".png" || ending == ".exr" || ending == ".npy")
            files.push_back(file->path());
    if (failure)
        return systemErrorFor(failure.value(), folder, attempted, ErrorCode::ReadFailed);
    std::sort(files.begin(), files.end(), isBeforeInNameOrder);
    if (int(files.size()) != frameCount)
        return Error{ErrorCode::TooLittleData, attempted,
                     "there are " + std::to_string(files.size()) +
                         " depth maps (.png, .exr, .npy) in it and the clip has " +
                         std::to_string(frameCount) + " frames",
                     "Give one a frame, in the order of their names", folder.string()};
    return files;
}

Result<GivenDepth> readDepthFile(const fs::path &path)
{
    if (endingOf(path) != ".npy")
        return decoded(path);
    const Result<std::string> bytes = readWholeFile(path, largestFile, attempted);
    if (!bytes)
        return bytes.error();
    return parseNpy(*bytes, path.string());
}

} // namespace ductus
