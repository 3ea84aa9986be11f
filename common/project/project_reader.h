// Opening projects: the bytes of a .ductus file in, a Project out. Never trusts, never crashes, never changes
// the file.
#pragma once

#include "project/migrations/migration_table.h"
#include "project/project.h"

#include <filesystem>
#include <span>
#include <string>

namespace ductus {

struct ProjectReadOptions
{
    ContainerLimits limits;
    const MigrationTable *migrations = nullptr; // null: the built-in ones
    std::vector<DocumentKind> kinds = {}; // besides sketch surfaces; documents of others are kept unread
};

/// Reads a project held in memory. \a name (the file's) starts the places in errors. NewerVersion names the
/// version needed when the file does not allow this one to read it; damaged or hostile files are Malformed,
/// Unsupported or TooLarge.
Result<Project> parseProject(std::span<const std::byte> bytes, const std::string &name,
                             const ProjectReadOptions &options = {});

/// Reads the file \a path; errors as above and those of readWholeFile().
Result<Project> openProject(const std::filesystem::path &path, const ProjectReadOptions &options = {});

} // namespace ductus
