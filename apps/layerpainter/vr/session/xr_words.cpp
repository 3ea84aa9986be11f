#include "layerpainter/vr/session/xr_words.h"

#include <openxr/openxr_reflection.h>

namespace ductus {

namespace {

std::string nameOf(XrResult result)
{
    switch (result) {
#define NAME(word, number)                                                                                   \
    case word:                                                                                               \
        return #word;
        XR_LIST_ENUM_XrResult(NAME)
#undef NAME
                default : return "OpenXR result " +
                          std::to_string(int(result));
    }
}

struct Words
{
    XrResult result;
    ErrorCode code;
    const char *problem, *remedy;
};

constexpr Words known[] = {
    {XR_ERROR_RUNTIME_UNAVAILABLE, ErrorCode::Unsupported, "no headset software (OpenXR runtime) was found",
     "Install and start the software of your headset, such as SteamVR or Monado, and make it the active "
     "OpenXR "
     "runtime"},
    {XR_ERROR_FORM_FACTOR_UNAVAILABLE, ErrorCode::Unsupported,
     "no headset is connected or it is switched off", "Switch the headset on and try again"},
    {XR_ERROR_FORM_FACTOR_UNSUPPORTED, ErrorCode::Unsupported,
     "the headset software knows no headsets, only other devices", "Choose another OpenXR runtime"},
    {XR_ERROR_EXTENSION_NOT_PRESENT, ErrorCode::Unsupported,
     "the headset software does not take pictures drawn with OpenGL (XR_KHR_opengl_enable is missing)",
     "Choose an OpenXR runtime with OpenGL, such as SteamVR or Monado"},
    {XR_ERROR_API_VERSION_UNSUPPORTED, ErrorCode::Unsupported, "the headset software speaks another OpenXR",
     "Update the headset software"},
    {XR_ERROR_GRAPHICS_DEVICE_INVALID, ErrorCode::Unsupported,
     "the headset software does not work with this graphics card",
     "Start LayerPainter on the headset's card"},
    {XR_ERROR_SESSION_LOST, ErrorCode::ReadFailed, "the connection to the headset was lost",
     "The painting is still here; connect the headset and enter VR again"},
    {XR_ERROR_INSTANCE_LOST, ErrorCode::ReadFailed, "the headset software stopped",
     "The painting is still here; start the headset software and enter VR again"},
    {XR_ERROR_LIMIT_REACHED, ErrorCode::Unsupported, "another program uses the headset",
     "Close the other program"},
};

} // namespace

Error xrError(const char *attempted, const char *function, XrResult result)
{
    const std::string place = std::string(function) + ": " + nameOf(result);
    for (const Words &words : known)
        if (words.result == result)
            return {words.code, attempted, words.problem, words.remedy, place};
    return {ErrorCode::Unsupported, attempted, "the headset software reported " + nameOf(result),
            "Restart the headset software and try again", place};
}

Result<void> checkXr(const char *attempted, const char *function, XrResult result)
{
    if (XR_FAILED(result))
        return xrError(attempted, function, result);
    return {};
}

} // namespace ductus
