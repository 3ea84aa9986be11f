#include "benchmarks/report/resource_meter.h"

#include <algorithm>
#include <fstream>
#include <malloc.h>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

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

// proc(5): the first line of /proc/stat, in clock ticks: user nice system idle iowait irq softirq steal, and
// guests, which are in user and nice already.
std::optional<MachineTime> machineTime()
{
    std::ifstream stat("/proc/stat");
    std::string name;
    stat >> name;
    MachineTime time;
    for (int field = 0; field < 8; ++field) {
        double ticks = 0.0;
        if (!(stat >> ticks))
            return std::nullopt;
        const double seconds = ticks / double(sysconf(_SC_CLK_TCK));
        const bool isIdle = field == 3 || field == 4;
        time.all += seconds;
        time.busy += isIdle ? 0.0 : seconds;
    }
    return name == "cpu" ? std::optional(time) : std::nullopt;
}

} // namespace

ResourceMeter::ResourceMeter()
{
    mPeakIsNew = restartPeak();
    mCpuStart = cpuSecondsSoFar();
    mMachineStart = machineTime();
    mWallStart = std::chrono::steady_clock::now();
}

ResourceUse ResourceMeter::used() const
{
    ResourceUse use;
    use.wallSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - mWallStart).count();
    use.cpuSeconds = cpuSecondsSoFar() - mCpuStart;
    if (mPeakIsNew)
        use.peakMegabytes = peakMegabytes();
    const std::optional<MachineTime> now = machineTime();
    if (mMachineStart && now && now->all > mMachineStart->all) {
        const double others = now->busy - mMachineStart->busy - use.cpuSeconds;
        use.othersShare = std::clamp(others / (now->all - mMachineStart->all), 0.0, 1.0);
    }
    return use;
}

} // namespace ductus
