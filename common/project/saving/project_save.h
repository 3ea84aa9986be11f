// Saving so that a kill at any instant loses nothing saved before: the new file is written beside the old
// one, flushed, read back and verified; the old one becomes name.ductus~; then one rename puts the new one in
// its place.
#pragma once

#include "project/project.h"

#include <filesystem>
#include <string>
#include <vector>

namespace ductus {

struct SaveReport
{
    std::uint64_t bytes = 0;
    int copiedBuffers = 0;
    int packedBuffers = 0;
    BufferStore buffers;               // put into Project::buffers (see project_writer.h)
    std::vector<std::string> warnings; // the previous version could not be kept
};

/// Writes \a project to \a path (through symbolic links). May run on a worker with a copy of the project. On
/// failure the old file is untouched: PermissionDenied, FileNotFound (the folder), WriteFailed (disk full),
/// those of serializedProject(). Callers hold a ProjectLock on \a path.
Result<SaveReport> saveProject(const Project &project, const std::filesystem::path &path);

/// name.ductus~
std::filesystem::path previousVersionPath(const std::filesystem::path &path);

} // namespace ductus
