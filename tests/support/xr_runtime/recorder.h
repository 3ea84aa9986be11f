// What the program did, a line each, in the file named by DUCTUS_XR_RECORD: every call that was wrong,
// states, haptics, and for each submitted frame from where it was seen.
//
//     error xrEndFrame -37              a call that broke the rules (not one that was told to fail)
//     state 5
//     haptic right 0.50 20              amplitude, milliseconds (-1: the shortest there is)
//     frame 12 layers 1 rendered 1
//     view 12 0 X Y Z QX QY QZ QW LEFT RIGHT UP DOWN      radians
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace ductus::xr {

class Recorder
{
public:
    /// No file: nothing is kept.
    explicit Recorder(const std::filesystem::path &file = {});
    void line(const std::string &text);

private:
    std::ofstream mStream;
};

} // namespace ductus::xr
