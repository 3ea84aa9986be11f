#include "project/container/container_reader.h"

#include "formats/archive/zip_directory.h"
#include "project/container/entry_name.h"

#include <zip.h>

#include <memory>
#include <new>
#include <optional>

namespace ductus {

namespace {

constexpr char attempted[] = "Reading the project";
constexpr char remedy[] = "Open the previous version of the file, its name ends in ~";

struct ZipDiscard
{
    void operator()(zip_t *zip) const { zip_discard(zip); }
};
struct ZipFileClose
{
    void operator()(zip_file_t *file) const { zip_fclose(file); }
};
using ZipPointer = std::unique_ptr<zip_t, ZipDiscard>;

Error malformed(std::string place, std::string problem, ErrorCode code = ErrorCode::Malformed)
{
    return {code, attempted, std::move(problem), remedy, std::move(place)};
}

Result<std::shared_ptr<zip_t>> openZip(std::span<const std::byte> bytes, const std::string &name)
{
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t *source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
    zip_t *zip = source ? zip_open_from_source(source, ZIP_RDONLY | ZIP_CHECKCONS, &error) : nullptr;
    std::string reason = zip ? std::string() : zip_error_strerror(&error);
    const bool repeatedName = !zip && zip_error_code_zip(&error) == ZIP_ER_EXISTS;
    zip_error_fini(&error);
    if (zip)
        return std::shared_ptr<zip_t>(zip, ZipDiscard());
    if (source)
        zip_source_free(source);
    if (repeatedName)
        return malformed(name, "two entries have the same name");
    return malformed(name, "this is not an intact zip container: " + reason);
}

// What the central directory says of one entry, bounds checked.
Result<zip_stat_t> checkedStat(zip_t *zip, zip_uint64_t index, const std::string &place,
                               const ContainerLimits &limits)
{
    zip_stat_t stat;
    zip_stat_init(&stat);
    constexpr zip_uint64_t needed =
        ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE | ZIP_STAT_CRC | ZIP_STAT_COMP_METHOD | ZIP_STAT_ENCRYPTION_METHOD;
    if (zip_stat_index(zip, index, 0, &stat) != 0 || (stat.valid & needed) != needed)
        return malformed(place, "the directory does not describe this entry");
    if (stat.encryption_method != ZIP_EM_NONE)
        return malformed(place, "the entry is encrypted", ErrorCode::Unsupported);
    if (stat.comp_method != ZIP_CM_STORE && stat.comp_method != ZIP_CM_DEFLATE)
        return malformed(place, "the entry is packed by a method other than Store and Deflate",
                         ErrorCode::Unsupported);
    if (stat.size > limits.maxEntryBytes || stat.comp_size > limits.maxFileBytes)
        return malformed(place, "the entry is too large", ErrorCode::TooLarge);
    if (stat.comp_method == ZIP_CM_STORE && stat.size != stat.comp_size)
        return malformed(place, "a stored entry has two different sizes");
    if (stat.size > limits.ratioFreeBytes && stat.size / limits.maxRatio >= stat.comp_size)
        return malformed(place, "the entry unpacks to far more than a project would hold",
                         ErrorCode::TooLarge);
    return stat;
}

Result<StoredEntry> readEntry(zip_t *zip, zip_uint64_t index, std::string name, const zip_stat_t &stat,
                              const std::string &place)
{
    const std::unique_ptr<zip_file_t, ZipFileClose> file(zip_fopen_index(zip, index, ZIP_FL_COMPRESSED));
    if (!file)
        return malformed(place, std::string("the entry cannot be opened: ") + zip_strerror(zip));
    auto packed = std::make_shared<Bytes>(stat.comp_size);
    for (std::size_t done = 0; done < packed->size();) {
        const zip_int64_t count = zip_fread(file.get(), packed->data() + done, packed->size() - done);
        if (count <= 0)
            return malformed(place, "the entry ends too early");
        done += std::size_t(count);
    }
    return StoredEntry{std::move(name), PackMethod(stat.comp_method), stat.crc, stat.size, std::move(packed)};
}

std::optional<Error> mimeTypeError(const std::optional<StoredEntry> &entry, const std::string &name)
{
    if (!entry)
        return malformed(name, "the entry mimetype is missing, so this is not a Ductus project");
    if (entry->size > 256)
        return malformed(name + ":mimetype", "this is not a Ductus project");
    const Result<Bytes> bytes = unpacked(*entry, name + ":mimetype");
    if (!bytes)
        return bytes.error();
    const std::string_view text(reinterpret_cast<const char *>(bytes->data()), bytes->size());
    if (text != ductusMimeType)
        return malformed(name + ":mimetype", "this is a container of another kind, not a Ductus project");
    return std::nullopt;
}

} // namespace

const StoredEntry *Container::find(std::string_view name) const
{
    const auto found = entries.find(name);
    return found == entries.end() ? nullptr : &found->second;
}

Result<Container> readContainer(std::span<const std::byte> bytes, const std::string &name,
                                const ContainerLimits &limits)
try {
    if (bytes.size() > limits.maxFileBytes)
        return malformed(name, "the file is too large", ErrorCode::TooLarge);
    if (largestEntryCount(bytes) > limits.maxEntries) // libzip would allocate for all of them when it opens
        return malformed(name, "the container has too many entries", ErrorCode::TooLarge);
    Result<std::shared_ptr<zip_t>> opened = openZip(bytes, name);
    if (!opened)
        return opened.error();
    zip_t *zip = opened->get();
    const zip_int64_t count = zip_get_num_entries(zip, 0);

    Container container;
    std::optional<StoredEntry> mimeType;
    std::uint64_t packedTotal = 0;
    std::uint64_t total = 0;
    for (zip_int64_t i = 0; i < count; ++i) {
        const auto index = zip_uint64_t(i);
        const char *rawName = zip_get_name(zip, index, ZIP_FL_ENC_RAW);
        if (!rawName)
            return malformed(name, "an entry has no name");
        std::string entryName = rawName;
        if (std::string problem = entryNameProblem(entryName); !problem.empty())
            return malformed(name, std::move(problem));
        const std::string place = name + ":" + entryName;
        const Result<zip_stat_t> stat = checkedStat(zip, index, place, limits);
        if (!stat)
            return stat.error();
        packedTotal += stat->comp_size;
        total += stat->size;
        if (packedTotal > bytes.size())
            return malformed(place, "entries overlap each other");
        if (total > limits.maxTotalBytes)
            return malformed(name, "the contents are too large", ErrorCode::TooLarge);
        Result<StoredEntry> entry = readEntry(zip, index, entryName, *stat, place);
        if (!entry)
            return entry.error();
        if (entryName == "mimetype" && !mimeType) {
            if (i != 0 || entry->method != PackMethod::Stored)
                container.warnings.push_back(
                    "the entry mimetype is not the first or is packed; the next save mends it");
            mimeType = std::move(*entry);
        } else if (entryName == "mimetype" ||
                   !container.entries.emplace(entryName, std::move(*entry)).second) {
            return malformed(place, "two entries have the same name");
        }
    }
    if (std::optional<Error> error = mimeTypeError(mimeType, name))
        return *error;
    return container;
} catch (const std::bad_alloc &) {
    return malformed(name, "there is not enough memory for this file", ErrorCode::TooLarge);
}

} // namespace ductus
