// The options of the surface command, read and checked.
#pragma once

#include "surfacing/pipeline/surface_options.h"

#include <QStringList>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace ductus {

/// Options of the engine that were on the command line.
struct GivenOptions
{
    std::optional<std::pair<SymmetryMode, SymmetryPlane>> symmetry;
    std::optional<double> epsilon, simplicity, smoothness, tightness, tubeRadius;
    std::optional<int> runs, proxyVertices;
    std::optional<std::uint64_t> seed;

    void applyTo(SurfaceOptions &options) const;
};

struct SurfaceArguments
{
    std::vector<std::filesystem::path> inputs; // at least one
    std::filesystem::path output;
    std::filesystem::path proxy;                                       // empty: made automatically
    std::filesystem::path scribbles;                                   // empty: none
    std::filesystem::path report;                                      // empty: none
    std::filesystem::path picture;                                     // empty: none
    std::filesystem::path ambiguity;                                   // .png or .json; empty: none
    std::vector<int> boundaryStrokes, ignoredStrokes, skeletalStrokes; // 0-based, in file order
    bool findCables = true;                                            // --parts auto
    bool quiet = false;
    SurfaceOptions options; // with the defaults where nothing was given
    GivenOptions given;     // to be laid over those stored in a project
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
