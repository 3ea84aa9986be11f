#include "project/saving/project_save.h"

#include "base/sha256.h"
#include "formats/atomic_file.h"
#include "project/container/container_reader.h"
#include "project/container/entry_name.h"
#include "project/project_writer.h"
#include "project/saving/temporary_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>

namespace ductus {

namespace fs = std::filesystem;

namespace {

constexpr char attempted[] = "Saving the project";

Error saveError(ErrorCode code, std::string problem, std::string remedy, const fs::path &place)
{
    return {code, attempted, std::move(problem), std::move(remedy), place.string()};
}

// Where the bytes really go: a project reached by a link stays a link.
Result<fs::path> resolvedTarget(const fs::path &path)
{
    std::error_code error;
    fs::path target = path;
    if (fs::is_symlink(fs::symlink_status(path, error))) {
        target = fs::weakly_canonical(path, error);
        if (error)
            return saveError(ErrorCode::WriteFailed, error.message(), "", path);
    }
    const fs::file_status status = fs::status(target, error);
    if (fs::exists(status) && !fs::is_regular_file(status))
        return saveError(ErrorCode::NotAFile, "this is not a file", "Choose another name", path);
    if (fs::exists(status) && ::faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0)
        return saveError(ErrorCode::PermissionDenied, "the file is read-only", "Save under another name",
                         path);
    return target;
}

// What stands on the disk must be what was meant, and a container whose buffers have the content they are
// named after.
Result<void> verify(const fs::path &written, const SerializedProject &meant,
                    const std::set<std::string> &keptBuffers)
{
    const Result<std::string> content = readWholeFile(written, ContainerLimits().maxFileBytes, attempted);
    if (!content)
        return content.error();
    if (!std::ranges::equal(asBytes(*content), meant.bytes))
        return saveError(ErrorCode::WriteFailed, "the disk gives back other bytes than were written",
                         "Save to another disk", written);
    const Result<Container> container = readContainer(asBytes(*content), written.filename().string());
    if (!container)
        return container.error();
    for (const auto &[name, entry] : container->entries) {
        const std::string hash(sha256OfBufferEntry(name));
        if (hash.empty() ||
            keptBuffers.contains(hash)) // others' buffers go through as they came, damaged or not
            continue;
        const Result<Bytes> bytes = unpacked(entry, name);
        if (!bytes || sha256Hex(*bytes) != hash)
            return saveError(ErrorCode::WriteFailed, "the buffer " + hash + " is damaged", "Save again",
                             written);
    }
    return {};
}

// The old file also under the name of the previous version; at no instant is either of them missing.
std::string keepPrevious(const fs::path &target)
{
    std::error_code error;
    if (!fs::exists(target, error))
        return {};
    const fs::path previous = previousVersionPath(target);
    const fs::path link = temporaryName(target);
    fs::create_hard_link(target, link, error);
    if (!error) {
        fs::rename(link, previous, error);
        std::error_code ignored; // renaming one link of a file over another does nothing and leaves both
        fs::remove(link, ignored);
    } else { // a disk without links
        const Result<std::string> content = readWholeFile(target, ContainerLimits().maxFileBytes, attempted);
        const Result<void> copied = content ? writeFileAtomically(previous, asBytes(*content), attempted)
                                            : Result<void>(content.error());
        return copied ? "" : "The previous version could not be kept: " + copied.error().problem + ".";
    }
    return error ? "The previous version could not be kept: " + error.message() + "." : "";
}

} // namespace

fs::path previousVersionPath(const fs::path &path)
{
    fs::path previous = path;
    previous += "~";
    return previous;
}

Result<SaveReport> saveProject(const Project &project, const fs::path &path)
{
    const Result<fs::path> target = resolvedTarget(path);
    if (!target)
        return target.error();
    Result<SerializedProject> serialized = serializedProject(project);
    if (!serialized)
        return serialized.error();
    removeLeftovers(*target);
    Result<TemporaryFile> file = TemporaryFile::createBeside(*target);
    if (!file)
        return file.error();
    file->copyPermissions(*target);
    if (Result<void> written = file->write(serialized->bytes); !written)
        return written.error();
    if (Result<void> verified = verify(file->path(), *serialized, project.keptBuffers); !verified)
        return verified.error();

    SaveReport report;
    if (std::string warning = keepPrevious(*target); !warning.empty())
        report.warnings.push_back(std::move(warning));
    if (Result<void> renamed = file->renameTo(*target); !renamed)
        return renamed.error();
    report.bytes = serialized->bytes.size();
    report.copiedBuffers = serialized->copiedBuffers;
    report.packedBuffers = serialized->packedBuffers;
    report.buffers = std::move(serialized->buffers);
    return report;
}

} // namespace ductus
