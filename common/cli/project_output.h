// Commands that change a project file where it is, or write the changed one elsewhere.
#pragma once

#include "project/project.h"

#include <filesystem>
#include <string>

namespace ductus {

/// Saves \a project at \a path as the apps do: under its lock, the previous version kept beside it. \a
/// attempted: "Updating the surfaces". Errors: Locked while an app has it open, those of checkWritable and
/// saveProject.
Result<void> saveProjectFile(const Project &project, const std::filesystem::path &path,
                             const std::string &attempted);

} // namespace ductus
