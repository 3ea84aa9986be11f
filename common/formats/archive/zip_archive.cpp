#include "formats/archive/zip_archive.h"

#include "formats/archive/zip_directory.h"

#include <zip.h>

#include <algorithm>
#include <fstream>
#include <system_error>

namespace ductus {

namespace {

constexpr char attempted[] = "Reading the painting";
constexpr std::uint64_t mostEntries =
    65534; // one more stands for "see the zip64 record", which is not looked for
constexpr std::uint64_t endSearched = 1 << 17;

struct CloseEntry
{
    void operator()(zip_file_t *file) const { zip_fclose(file); }
};
using OpenEntry = std::unique_ptr<zip_file_t, CloseEntry>;

Error archiveError(std::string name, std::string problem)
{
    return {ErrorCode::Malformed, attempted, std::move(problem), "Copy or export the file again",
            std::move(name)};
}

std::string lowerCase(std::string_view text)
{
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return c < 128 ? char(std::tolower(c)) : char(c); });
    return lower;
}

/// libzip allocates for as many entries as the directory claims.
std::optional<Error> tooManyEntries(std::span<const std::byte> end, const std::string &name)
{
    if (largestEntryCount(end) > mostEntries)
        return archiveError(name, "its directory claims more entries than a painting has");
    return std::nullopt;
}

} // namespace

struct ZipArchive::Content
{
    zip_t *zip = nullptr;
    std::string name;

    ~Content()
    {
        if (zip)
            zip_discard(zip);
    }
};

class ZipEntrySource : public ByteSource
{
public:
    ZipEntrySource(std::shared_ptr<ZipArchive::Content> content, zip_uint64_t index, std::string name,
                   std::uint64_t size)
        : ByteSource(std::move(name), size), mContent(std::move(content)), mIndex(index)
    {
    }

protected:
    Result<void> readInside(std::uint64_t offset, std::span<std::byte> destination) override
    {
        if (!mFile || offset < mPosition) {
            mFile.reset(zip_fopen_index(mContent->zip, mIndex, 0));
            mPosition = 0;
            if (!mFile)
                return archiveError(name(),
                                    std::string("it cannot be unpacked: ") + zip_strerror(mContent->zip));
        }
        std::vector<std::byte> ignored(std::size_t(std::min<std::uint64_t>(offset - mPosition, 1 << 16)));
        while (mPosition < offset) {
            const auto count = std::size_t(std::min<std::uint64_t>(offset - mPosition, ignored.size()));
            if (const auto error = unpack(std::span(ignored).first(count)))
                return *error;
        }
        if (const auto error = unpack(destination))
            return *error;
        return {};
    }

private:
    std::optional<Error> unpack(std::span<std::byte> destination)
    {
        while (!destination.empty()) {
            const zip_int64_t count = zip_fread(mFile.get(), destination.data(), destination.size());
            if (count <= 0) {
                const Error error = archiveError(place(mPosition), "its packed data is damaged");
                mFile.reset();
                return error;
            }
            mPosition += std::uint64_t(count);
            destination = destination.subspan(std::size_t(count));
        }
        return std::nullopt;
    }

    std::shared_ptr<ZipArchive::Content> mContent; // closed after the entry
    zip_uint64_t mIndex;
    OpenEntry mFile;
    std::uint64_t mPosition = 0;
};

Result<ZipArchive> ZipArchive::openSource(void *zipSource, std::string name)
{
    auto *source = static_cast<zip_source_t *>(zipSource);
    if (!source)
        return archiveError(std::move(name), "the file cannot be opened");
    auto content = std::make_shared<Content>();
    content->name = name;
    zip_error_t error;
    zip_error_init(&error);
    content->zip = zip_open_from_source(source, ZIP_RDONLY, &error);
    const std::string reason = content->zip ? "" : zip_error_strerror(&error);
    zip_error_fini(&error);
    if (!content->zip) {
        zip_source_free(source);
        return archiveError(std::move(name), "it is not an intact zip archive: " + reason);
    }
    return ZipArchive(std::move(content));
}

Result<ZipArchive> ZipArchive::open(const std::filesystem::path &path, std::uint64_t prefix, std::string name)
{
    Result<std::unique_ptr<ByteSource>> file = openFileSource(path, name);
    if (!file)
        return file.error();
    const std::uint64_t size = (*file)->size();
    std::vector<std::byte> end(std::size_t(std::min(size, endSearched)));
    const Result<void> done = (*file)->read(size - end.size(), end);
    if (!done)
        return done.error();
    if (const auto error = tooManyEntries(end, name))
        return *error;
    return openSource(zip_source_file_create(path.c_str(), prefix, -1, nullptr), std::move(name));
}

Result<ZipArchive> ZipArchive::openMemory(std::string_view bytes, std::string name)
{
    if (const auto error = tooManyEntries(std::as_bytes(std::span(bytes)), name))
        return *error;
    return openSource(zip_source_buffer_create(bytes.data(), bytes.size(), 0, nullptr), std::move(name));
}

Result<std::unique_ptr<ByteSource>> ZipArchive::entry(std::string_view fileName) const
{
    const std::string wanted = lowerCase(fileName);
    const zip_int64_t count = zip_get_num_entries(mContent->zip, 0);
    for (zip_int64_t i = 0; i < count; ++i) {
        zip_stat_t stat;
        zip_stat_init(&stat);
        if (zip_stat_index(mContent->zip, zip_uint64_t(i), 0, &stat) != 0 || !(stat.valid & ZIP_STAT_NAME))
            continue;
        const std::string_view entryName = stat.name;
        const std::size_t slash = entryName.find_last_of("/\\");
        if (lowerCase(slash == std::string_view::npos ? entryName : entryName.substr(slash + 1)) != wanted)
            continue;
        const std::string place = mContent->name + ": " + std::string(entryName);
        if (!(stat.valid & ZIP_STAT_SIZE))
            return archiveError(place, "its size is not known");
        return std::unique_ptr<ByteSource>(new ZipEntrySource(mContent, zip_uint64_t(i), place, stat.size));
    }
    return Error{ErrorCode::FileNotFound, attempted, "it holds no " + std::string(fileName),
                 "Pack the whole project again", mContent->name};
}

} // namespace ductus
