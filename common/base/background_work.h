// Work that must not make a window wait: long jobs use all cores, and so do windows that draw without a GPU.
#pragma once

#include <memory>

namespace ductus {

/// While one lives, the thread that made it and the threads that help it in parallelFor give way to others of
/// this program: the system runs them at a lower priority (nice value), which they keep. Make it in a thread
/// of its own, first. Where the system refuses, they run as before.
class BackgroundWork
{
public:
    BackgroundWork();
    ~BackgroundWork();
    BackgroundWork(const BackgroundWork &) = delete;
    BackgroundWork &operator=(const BackgroundWork &) = delete;

private:
    class Helpers;
    std::unique_ptr<Helpers> mHelpers;
};

} // namespace ductus
