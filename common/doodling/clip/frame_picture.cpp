#include "doodling/clip/frame_picture.h"

#include "doodling/clip/clip.h"

#include <algorithm>
#include <cmath>
#include <utility>

extern "C" {
#include <libavutil/pixdesc.h>
}

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

// One of SWS_CS_*. Films that do not say are taken as players take them: the large ones as BT.709.
int matrixOf(const AVFrame &frame, bool isFullRange)
{
    switch (frame.colorspace) {
    case AVCOL_SPC_BT709:
        return SWS_CS_ITU709;
    case AVCOL_SPC_BT470BG:
    case AVCOL_SPC_SMPTE170M:
        return SWS_CS_ITU601;
    case AVCOL_SPC_SMPTE240M:
        return SWS_CS_SMPTE240M;
    case AVCOL_SPC_FCC:
        return SWS_CS_FCC;
    case AVCOL_SPC_BT2020_NCL:
    case AVCOL_SPC_BT2020_CL:
        return SWS_CS_BT2020;
    default:
        break;
    }
    const bool isPhoto = isFullRange; // JPEG has BT.601 at every size
    return !isPhoto && std::min(frame.width, frame.height) >= 720 ? SWS_CS_ITU709 : SWS_CS_ITU601;
}

bool hasFullRange(const AVFrame &frame)
{
    return frame.color_range == AVCOL_RANGE_JPEG || frame.format == AV_PIX_FMT_YUVJ420P ||
           frame.format == AV_PIX_FMT_YUVJ422P || frame.format == AV_PIX_FMT_YUVJ444P ||
           frame.format == AV_PIX_FMT_YUVJ440P || frame.format == AV_PIX_FMT_YUVJ411P;
}

} // namespace

void FramePicture::setColours(const AVFrame &frame)
{
    const AVPixFmtDescriptor *kind = av_pix_fmt_desc_get(AVPixelFormat(frame.format));
    if (!kind || (kind->flags & AV_PIX_FMT_FLAG_RGB))
        return;
    const int range = hasFullRange(frame), matrix = matrixOf(frame, range != 0);
    if (range == mRange && matrix == mMatrix)
        return;
    const int *coefficients = sws_getCoefficients(matrix);
    sws_setColorspaceDetails(mScaler.get(), coefficients, range, coefficients, 1, 0, 1 << 16, 1 << 16);
    mRange = range;
    mMatrix = matrix;
}

Result<Image> FramePicture::make(const AVFrame &frame, int rotationDegrees, int mostLines)
{
    const bool isSideways = rotationDegrees % 180 != 0;
    auto [width, height] = scaledSize(isSideways ? frame.height : frame.width,
                                      isSideways ? frame.width : frame.height, mostLines);
    if (isSideways)
        std::swap(width, height);
    // Area averaging keeps fine texture from turning into noise when frames are made small.
    const SwsContext *before = mScaler.get();
    mScaler.reset(sws_getCachedContext(mScaler.release(), frame.width, frame.height,
                                       AVPixelFormat(frame.format), width, height, AV_PIX_FMT_RGBA,
                                       SWS_AREA | SWS_ACCURATE_RND, nullptr, nullptr, nullptr));
    if (!mScaler)
        return Error{ErrorCode::Unsupported, "Reading the clip",
                     "its pixels are of a kind that cannot be converted", "Convert the clip to MP4 (H.264)",
                     ""};
    if (mScaler.get() != before)
        mRange = mMatrix = -1;
    setColours(frame);
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
