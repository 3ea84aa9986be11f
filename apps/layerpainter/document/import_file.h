// Other programs' files as paintings: Quill and .tilt paintings, meshes, surfaces of SketchSurfacer.
#pragma once

#include "base/job_control.h"
#include "formats/painting_file.h"
#include "painting/scene/painting.h"
#include "project/project.h"

#include <filesystem>

namespace ductus {

struct ImportedFile
{
    Painting painting;
    std::string kind;            // "quill", "tilt", "mesh", "sketch-surface"
    std::string name;            // of the painting, from the file's
    PaintingImportReport report; // of Quill and .tilt: what was read and what was skipped
    std::vector<std::string> notes;
};

struct FileImportOptions
{
    bool firstFrameOnly = false; // of frame-by-frame layers
    /// The folder links to other projects are seen from; empty: from anywhere.
    std::filesystem::path seenFrom = {};
};

/// Quill folder, Quill.json or .quill; .tilt; OBJ, PLY, STL, OFF, GLB (one stack, clay colour); .ductus (each
/// finished surface a stack). Errors name file, place and remedy; nothing is half imported.
Result<ImportedFile> importFile(const std::filesystem::path &path, const FileImportOptions &options,
                                const JobControl &control);

/// Each finished surface of SketchSurfacer in \a project a stack, linked to its sketch; TooLittleData if
/// there is none. \a file: DocumentLink::file.
Result<ImportedFile> importSurfaces(const Project &project, const std::string &name,
                                    const std::string &file = {});

} // namespace ductus
