// HeadsetRuntime: the headset's software, and the headset it has.
#pragma once

#include "base/result.h"

#include <openxr/openxr.h>

#include <memory>
#include <optional>
#include <string>

namespace ductus {

class HeadsetRuntime
{
public:
    /// Unsupported with what is missing: software, a headset, OpenGL.
    static Result<std::unique_ptr<HeadsetRuntime>> find();
    ~HeadsetRuntime();
    HeadsetRuntime(const HeadsetRuntime &) = delete;
    HeadsetRuntime &operator=(const HeadsetRuntime &) = delete;

    XrInstance instance() const { return mInstance; }
    XrSystemId system() const { return mSystem; }
    const std::string &name() const { return mName; }

    /// The next thing that happened; none when there is nothing, an error when the software is gone.
    Result<std::optional<XrEventDataBuffer>> nextEvent() const;

    XrPath path(const std::string &text) const;
    std::string text(XrPath path) const;

private:
    HeadsetRuntime() = default;

    XrInstance mInstance = XR_NULL_HANDLE;
    XrSystemId mSystem = XR_NULL_SYSTEM_ID;
    std::string mName;
};

} // namespace ductus
