#include "doodling/clip/frame_picture.h"

#include "doodling/clip/clip.h"

#include <cmath>
#include <utility>

namespace ductus {

namespace {

// Clockwise by 90, 180 or 270 degrees.
Image turned(const Image &image, int degrees)
{
    const bool isSideways = degrees % 180 != 0;
    Image result(isSideways ? image.height : image.width, isSideways ? image.width : image.height);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const int right = image.width - 1 - x, low = image.height - 1 - y;
            if (degrees == 90)
                result.set(low, x, image.at(x, y));
            else if (degrees == 180)
                result.set(right, low, image.at(x, y));
            else
                result.set(y, right, image.at(x, y));
        }
    return result;
}

} // namespace

Result<Image> FramePicture::make(const AVFrame &frame, int rotationDegrees, int mostLines)
{
    const bool isSideways = rotationDegrees % 180 != 0;
    auto [width, height] = scaledSize(isSideways ? frame.height : frame.width,
                                      isSideways ? frame.width : frame.height, mostLines);
    if (isSideways)
        std::swap(width, height);
    // Area averaging keeps fine texture from turning into noise when frames are made small.
    mScaler.reset(sws_getCachedContext(mScaler.release(), frame.width, frame.height,
                                       AVPixelFormat(frame.format), width, height, AV_PIX_FMT_RGBA,
                                       SWS_AREA | SWS_ACCURATE_RND, nullptr, nullptr, nullptr));
    if (!mScaler)
        return Error{ErrorCode::Unsupported, "Reading the clip",
                     "its pixels are of a kind that cannot be converted", "Convert the clip to MP4 (H.264)",
                     ""};
    Image picture(width, height);
    std::uint8_t *const planes[] = {picture.pixels.data()};
    const int strides[] = {width * 4};
    sws_scale(mScaler.get(), frame.data, frame.linesize, 0, frame.height, planes, strides);
    return rotationDegrees == 0 ? std::move(picture) : turned(picture, rotationDegrees);
}

std::pair<int, int> scaledSize(int width, int height, int mostLines)
{
    if (mostLines <= 0 || height <= mostLines)
        return {width, height};
    const int scaledHeight = mostLines / 2 * 2;
    const int scaledWidth = 2 * int(std::lround(0.5 * width * scaledHeight / height));
    return {std::max(2, scaledWidth), std::max(2, scaledHeight)};
}

} // namespace ductus
