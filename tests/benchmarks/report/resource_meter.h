// What a piece of work costs: wall seconds, CPU seconds of all threads, peak resident memory.
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
    bool mPeakIsNew = false;
};

} // namespace ductus
