// ZipArchive: entries of a foreign zip (.quill, .tilt) as byte sources. Packed entries are unpacked while
// they are read and never held whole; reading forwards is one pass, reading backwards starts again.
#pragma once

#include "formats/archive/byte_source.h"

namespace ductus {

class ZipArchive
{
public:
    /// \a prefix bytes stand before the zip (16 in a .tilt).
    static Result<ZipArchive> open(const std::filesystem::path &path, std::uint64_t prefix, std::string name);
    /// \a bytes must outlive the archive.
    static Result<ZipArchive> openMemory(std::string_view bytes, std::string name);

    /// The entry whose last path component is \a fileName, in any case; FileNotFound if there is none. The
    /// source keeps the archive open.
    Result<std::unique_ptr<ByteSource>> entry(std::string_view fileName) const;

private:
    struct Content;
    explicit ZipArchive(std::shared_ptr<Content> content) : mContent(std::move(content)) {}
    static Result<ZipArchive> openSource(void *zipSource, std::string name);

    friend class ZipEntrySource;
    std::shared_ptr<Content> mContent;
};

} // namespace ductus
