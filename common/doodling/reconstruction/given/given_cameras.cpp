#include "doodling/reconstruction/given/given_cameras.h"

#include "formats/atomic_file.h"

namespace ductus {

namespace {

constexpr char attempted[] = "Reading the cameras";
constexpr std::size_t largestFile = 512u << 20;

} // namespace

Result<GivenCameras> readGivenCameras(const std::filesystem::path &path, int frameCount, int clipWidth,
                                      int clipHeight)
{
    std::error_code failure;
    if (!std::filesystem::is_directory(path, failure)) {
        const Result<std::string> text = readWholeFile(path, largestFile, attempted);
        if (!text)
            return text.error();
        return parseCameraJson(*text, path.filename().string(), frameCount, clipWidth, clipHeight);
    }
    if (!std::filesystem::exists(path / "cameras.txt", failure) &&
        std::filesystem::exists(path / "cameras.bin", failure))
        return Error{ErrorCode::Unsupported, attempted, "this is a COLMAP model in binary form",
                     "Convert it: colmap model_converter --output_type TXT", path.string()};
    const Result<std::string> cameras = readWholeFile(path / "cameras.txt", largestFile, attempted);
    if (!cameras)
        return cameras.error();
    const Result<std::string> images = readWholeFile(path / "images.txt", largestFile, attempted);
    if (!images)
        return images.error();
    return parseColmap(*cameras, *images, path.filename().string(), frameCount, clipWidth, clipHeight);
}

} // namespace ductus
