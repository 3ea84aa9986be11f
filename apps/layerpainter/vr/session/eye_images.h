// EyeImages: what an eye is shown: the images the headset's software gives out in turn.
#pragma once

#include "base/result.h"
#include "render/gl/gl_object.h"

#include <openxr/openxr.h>

#include <memory>
#include <vector>

namespace ductus {

class HeadsetRuntime;

struct EyeSize
{
    int width = 0, height = 0; // pixels
    int samples = 1;
};

/// As the headset's software recommends, for each eye.
Result<std::vector<EyeSize>> recommendedSizes(const HeadsetRuntime &runtime);

/// The best for a picture in sRGB of those offered: 0x8C43 (sRGB itself) before what holds linear light with
/// enough digits. Unsupported if there is none.
Result<std::int64_t> chooseFormat(const std::vector<std::int64_t> &offered);
Result<std::int64_t> chooseFormat(XrSession session);

class EyeImages
{
public:
    static Result<std::unique_ptr<EyeImages>> create(XrSession session, std::int64_t format,
                                                     const EyeSize &size);
    ~EyeImages();
    EyeImages(const EyeImages &) = delete;
    EyeImages &operator=(const EyeImages &) = delete;

    int width() const { return mSize.width; }
    int height() const { return mSize.height; }
    XrSwapchain handle() const { return mSwapchain; }
    /// The image's values are linear light, to be converted when drawing.
    bool isLinear() const;

    /// The framebuffer to draw the next frame onto.
    Result<GLuint> acquire();
    Result<void> release();

private:
    EyeImages() = default;

    XrSwapchain mSwapchain = XR_NULL_HANDLE;
    std::int64_t mFormat = 0;
    EyeSize mSize;
    std::vector<GlFramebuffer> mTargets;
};

} // namespace ductus
