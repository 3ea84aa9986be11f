// The options of the surface command, read and checked.
#pragma once

#include "surfacing/pipeline/surface_pipeline.h"

#include <QStringList>
#include <filesystem>
#include <vector>

namespace ductus {

struct SurfaceArguments
{
    std::filesystem::path input;
    std::filesystem::path output;
    std::filesystem::path proxy;                      // empty: made automatically
    std::filesystem::path report;                     // empty: none
    std::filesystem::path picture;                    // empty: none
    std::vector<int> boundaryStrokes, ignoredStrokes; // 0-based, in file order
    bool quiet = false;
    SurfaceOptions options;
};

/// Either arguments, or a message to print: help on stdout (isHelp) or what is wrong with the usage.
struct ParsedSurfaceArguments
{
    std::optional<SurfaceArguments> arguments;
    QString message;
    bool isHelp = false;
};

ParsedSurfaceArguments parseSurfaceArguments(const QStringList &arguments);

} // namespace ductus
