#include "cli/project_output.h"

#include "cli/output_files.h"
#include "project/saving/project_lock.h"
#include "project/saving/project_save.h"

namespace ductus {

Result<void> saveProjectFile(const Project &project, const std::filesystem::path &path,
                             const std::string &attempted)
{
    if (Result<void> writable = checkWritable(path, attempted); !writable)
        return writable;
    const Result<ProjectLock> lock = ProjectLock::acquire(path, "ductus command");
    if (!lock)
        return lock.error();
    const Result<SaveReport> saved = saveProject(project, path);
    if (!saved)
        return saved.error();
    return {};
}

} // namespace ductus
