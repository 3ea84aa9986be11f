#include "support/xr_runtime/recorder.h"

namespace ductus::xr {

Recorder::Recorder(const std::filesystem::path &file)
{
    if (!file.empty())
        mStream.open(file, std::ios::app);
}

void Recorder::line(const std::string &text)
{
    if (mStream.is_open())
        mStream << text << '\n' << std::flush; // a test reads it while the program runs
}

} // namespace ductus::xr
