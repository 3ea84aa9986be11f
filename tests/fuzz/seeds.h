// Small valid files of every format, made here: what mutations start from.
#pragma once

#include <string>
#include <vector>

namespace ductus {

struct Seed
{
    enum Kind { Sketch, Mesh, Png };
    Kind kind;
    std::string name; // with the extension of the format
    std::string bytes;
};

std::vector<Seed> fuzzSeeds();

} // namespace ductus
