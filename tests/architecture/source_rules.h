// The rules of the tree (ARCHITECTURE.md), checked by reading its sources: who may include whom, where Qt and
// CGAL may appear, how long a file may be.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ductus {

/// Folders of common/ from bottom to top; a file may include only its own folder and those before it.
const std::vector<std::string> &layers();

/// Most lines a file below common/ and apps/ may have.
inline constexpr int longestFile = 800;

struct SourceReport
{
    std::vector<std::string> violations; // "common/base/x.h:12: ...", paths relative to the root, sorted
    int files = 0;                       // looked at
    int includes = 0;
};

/// Walks the .h and .cpp files of common/ and apps/ below \a root.
///  - common/X includes only X and lower layers; apps/X any layer and itself; nobody includes an app
///  - quoted includes begin with such a folder (tests may use support/); no "../"
///  - engine folders (base .. doodling) include no Qt header, except in _test.cpp
///  - CGAL headers appear in common/geometry alone
///  - no file is longer than longestFile
SourceReport checkSources(const std::filesystem::path &root);

} // namespace ductus
