// An OpenGL context without a window: for the command line, thumbnails, tests and benchmarks.
#pragma once

#include "base/result.h"

#include <string>

namespace ductus {

/// An EGL context of OpenGL 4.3 core or newer that needs no display (surfaceless; a pbuffer where that is not
/// offered). Current on the thread that made it until it is released or destroyed.
class OffscreenContext
{
public:
    /// Unsupported where there is no EGL or no OpenGL 4.3. The context is current afterwards.
    static Result<OffscreenContext> create();

    OffscreenContext(OffscreenContext &&other) noexcept;
    OffscreenContext &operator=(OffscreenContext &&other) noexcept;
    OffscreenContext(const OffscreenContext &) = delete;
    OffscreenContext &operator=(const OffscreenContext &) = delete;
    ~OffscreenContext();

    /// Onto this thread; it must not be current on another.
    Result<void> makeCurrent();
    void release();

    /// "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5"; current.
    std::string description() const;

private:
    OffscreenContext() = default;

    // EGL's own types are void pointers; its header would bring X11's macros here.
    void *mDisplay = nullptr;
    void *mContext = nullptr;
    void *mSurface = nullptr; // null: surfaceless
};

} // namespace ductus
