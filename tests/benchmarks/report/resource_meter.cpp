#include "benchmarks/report/resource_meter.h"

#include <fstream>
#include <malloc.h>
#include <string>
#include <sys/resource.h>

namespace ductus {

namespace {

double cpuSecondsSoFar()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval &t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// proc(5): writing 5 sets the peak (VmHWM) back to what is resident now.
bool restartPeak()
{
    malloc_trim(0); // what earlier work freed must not count
    std::ofstream file("/proc/self/clear_refs");
    file << "5";
    file.close();
    return bool(file);
}

std::optional<double> peakMegabytes()
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.rfind("VmHWM:", 0) == 0)
            return std::stod(line.substr(6)) / 1024.0; // the file says kB and means KiB
    return std::nullopt;
}

} // namespace

ResourceMeter::ResourceMeter()
{
    mPeakIsNew = restartPeak();
    mCpuStart = cpuSecondsSoFar();
    mWallStart = std::chrono::steady_clock::now();
}

ResourceUse ResourceMeter::used() const
{
    ResourceUse use;
    use.wallSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - mWallStart).count();
    use.cpuSeconds = cpuSecondsSoFar() - mCpuStart;
    if (mPeakIsNew)
        use.peakMegabytes = peakMegabytes();
    return use;
}

} // namespace ductus
