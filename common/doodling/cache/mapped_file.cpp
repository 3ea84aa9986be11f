#include "doodling/cache/mapped_file.h"

#include "formats/atomic_file.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace ductus {

namespace {

constexpr char attempted[] = "Reading what was found out about the clip";

} // namespace

Result<std::shared_ptr<const MappedFile>> MappedFile::open(const std::filesystem::path &path)
{
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0)
        return systemErrorFor(errno, path, attempted, ErrorCode::ReadFailed);
    struct stat facts = {};
    const bool isFile = ::fstat(file, &facts) == 0 && S_ISREG(facts.st_mode);
    void *begin = nullptr;
    if (isFile && facts.st_size > 0)
        begin = ::mmap(nullptr, std::size_t(facts.st_size), PROT_READ, MAP_PRIVATE, file, 0);
    const int problem = errno;
    ::close(file);
    if (!isFile || begin == MAP_FAILED)
        return systemErrorFor(isFile ? problem : EINVAL, path, attempted, ErrorCode::ReadFailed);
    return std::shared_ptr<const MappedFile>(
        new MappedFile(static_cast<const std::byte *>(begin), std::size_t(facts.st_size)));
}

MappedFile::~MappedFile()
{
    if (mBegin)
        ::munmap(const_cast<std::byte *>(mBegin), mSize);
}

void MappedFile::forgetPages() const
{
    if (mBegin)
        ::madvise(const_cast<std::byte *>(mBegin), mSize, MADV_DONTNEED);
}

} // namespace ductus
