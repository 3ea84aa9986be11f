// What a piece of work costs: wall seconds, CPU seconds of all threads, peak resident memory; and how much
// of the machine others used meanwhile, without which wall seconds cannot be read.
#pragma once

#include <chrono>
#include <optional>

namespace ductus {

struct ResourceUse
{
    double wallSeconds = 0.0;
    double cpuSeconds = 0.0;
    /// Highest resident memory of the process meanwhile, what it held before included; nothing where the
    /// system cannot start a new peak.
    std::optional<double> peakMegabytes;
    /// Of all processors' time, what other processes used meanwhile, 0..1; nothing where the system does not
    /// say.
    std::optional<double> othersShare;
};

/// Seconds of all processors since the machine was started.
struct MachineTime
{
    double busy = 0.0;
    double all = 0.0;
};

/// Measures from its construction on; meters must not overlap, the peak is the process's.
class ResourceMeter
{
public:
    ResourceMeter();
    ResourceUse used() const;

private:
    std::chrono::steady_clock::time_point mWallStart;
    double mCpuStart = 0.0;
    std::optional<MachineTime> mMachineStart;
    bool mPeakIsNew = false;
};

} // namespace ductus
