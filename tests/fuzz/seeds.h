// Small valid files of every format, made here: what mutations start from.
#pragma once

#include <string>
#include <vector>

namespace ductus {

struct Seed
{
    enum Kind { Sketch, Mesh, Png, Quill, Tilt };
    Kind kind;
    std::string name;  // with the extension of the format
    std::string bytes; // of a Quill project: Quill.json, a zero byte, Quill.qbin; of a .tilt: data.sketch
};

std::vector<Seed> fuzzSeeds();

} // namespace ductus
