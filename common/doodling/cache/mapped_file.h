// A file read where it lies: the system brings its pages when they are touched and may take them back.
#pragma once

#include "base/result.h"

#include <filesystem>
#include <memory>
#include <span>

namespace ductus {

class MappedFile
{
public:
    /// The file may be replaced or removed while it is mapped, but must not be written into.
    static Result<std::shared_ptr<const MappedFile>> open(const std::filesystem::path &path);
    ~MappedFile();
    MappedFile(const MappedFile &) = delete;
    MappedFile &operator=(const MappedFile &) = delete;

    std::span<const std::byte> bytes() const { return {mBegin, mSize}; }
    /// Gives the memory back; what is touched later is read again. Safe while others read.
    void forgetPages() const;

private:
    MappedFile(const std::byte *begin, std::size_t size) : mBegin(begin), mSize(size) {}

    const std::byte *mBegin;
    std::size_t mSize;
};

} // namespace ductus
