#include "project/container/container_writer.h"

#include "project/container/container_reader.h"
#include "project/container/entry_name.h"

#include <zip.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <new>
#include <set>

namespace ductus {

namespace {

constexpr char attempted[] = "Writing the project";
constexpr zip_uint16_t firstDosDate = 0x0021; // 1980-01-01, the earliest a zip can say

Error writeError(ErrorCode code, std::string problem, std::string place = {})
{
    return {code, attempted, std::move(problem), "", std::move(place)};
}

// A libzip source that hands over bytes which are packed already: its stat names the method, so libzip copies
// them.
struct PackedSource
{
    const StoredEntry *entry;
    std::size_t offset = 0;
    zip_error_t error;
};

zip_int64_t readPacked(PackedSource &source, void *data, zip_uint64_t length)
{
    const Bytes &packed = *source.entry->packed;
    const std::size_t count = std::min<std::size_t>(length, packed.size() - source.offset);
    if (count > 0)
        std::memcpy(data, packed.data() + source.offset, count);
    source.offset += count;
    return zip_int64_t(count);
}

zip_int64_t packedSourceCallback(void *state, void *data, zip_uint64_t length, zip_source_cmd_t command)
{
    auto &source = *static_cast<PackedSource *>(state);
    switch (command) {
    case ZIP_SOURCE_OPEN:
        source.offset = 0;
        return 0;
    case ZIP_SOURCE_READ:
        return readPacked(source, data, length);
    case ZIP_SOURCE_CLOSE:
        return 0;
    case ZIP_SOURCE_STAT: {
        auto &stat = *static_cast<zip_stat_t *>(data);
        zip_stat_init(&stat);
        stat.size = source.entry->size;
        stat.comp_size = source.entry->packed->size();
        stat.crc = source.entry->crc32;
        stat.comp_method = zip_uint16_t(source.entry->method);
        stat.encryption_method = ZIP_EM_NONE;
        stat.valid = ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE | ZIP_STAT_CRC | ZIP_STAT_COMP_METHOD |
                     ZIP_STAT_ENCRYPTION_METHOD;
        return sizeof(zip_stat_t);
    }
    case ZIP_SOURCE_ERROR:
        return zip_error_to_data(&source.error, data, length);
    case ZIP_SOURCE_FREE:
        zip_error_fini(&source.error);
        delete &source;
        return 0;
    case ZIP_SOURCE_SUPPORTS:
        return zip_source_make_command_bitmap(ZIP_SOURCE_OPEN, ZIP_SOURCE_READ, ZIP_SOURCE_CLOSE,
                                              ZIP_SOURCE_STAT, ZIP_SOURCE_ERROR, ZIP_SOURCE_FREE, -1);
    default:
        zip_error_set(&source.error, ZIP_ER_OPNOTSUPP, 0);
        return -1;
    }
}

Result<void> addEntry(zip_t *zip, const StoredEntry &entry)
{
    auto *state = new PackedSource{&entry, 0, {}};
    zip_error_init(&state->error);
    zip_source_t *source = zip_source_function(zip, packedSourceCallback, state);
    if (!source) {
        delete state;
        return writeError(ErrorCode::WriteFailed, zip_strerror(zip), entry.name);
    }
    const zip_int64_t index = zip_file_add(zip, entry.name.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (index < 0) {
        zip_source_free(source);
        return writeError(ErrorCode::WriteFailed, zip_strerror(zip), entry.name);
    }
    const auto method = entry.method == PackMethod::Stored ? ZIP_CM_STORE : ZIP_CM_DEFLATE;
    if (zip_set_file_compression(zip, zip_uint64_t(index), method, 0) != 0 ||
        zip_file_set_dostime(zip, zip_uint64_t(index), 0, firstDosDate, 0) != 0)
        return writeError(ErrorCode::WriteFailed, zip_strerror(zip), entry.name);
    return {};
}

Result<void> checkLimits(std::span<const StoredEntry> entries, const ContainerLimits &limits)
{
    std::set<std::string_view> names;
    std::uint64_t total = 0;
    std::uint64_t packedTotal = 0;
    for (const StoredEntry &entry : entries) {
        if (std::string problem = entryNameProblem(entry.name); !problem.empty())
            return writeError(ErrorCode::InvalidArgument, std::move(problem), entry.name);
        if (entry.name == "mimetype" || !names.insert(entry.name).second)
            return writeError(ErrorCode::InvalidArgument, "two entries have the same name", entry.name);
        if (entry.size > limits.maxEntryBytes)
            return writeError(ErrorCode::TooLarge, "the entry is too large for a project", entry.name);
        total += entry.size;
        packedTotal += entry.packed->size() + 2 * entry.name.size() + 256;
    }
    if (entries.size() + 1 > limits.maxEntries || total > limits.maxTotalBytes ||
        packedTotal > limits.maxFileBytes)
        return writeError(ErrorCode::TooLarge, "the project holds more than a file may");
    return {};
}

Result<Bytes> contentOf(zip_source_t *source)
{
    zip_stat_t stat;
    zip_stat_init(&stat);
    if (zip_source_stat(source, &stat) != 0 || !(stat.valid & ZIP_STAT_SIZE) || zip_source_open(source) != 0)
        return writeError(ErrorCode::WriteFailed, zip_error_strerror(zip_source_error(source)));
    Bytes bytes(stat.size);
    const zip_int64_t count = zip_source_read(source, bytes.data(), bytes.size());
    zip_source_close(source);
    if (count < 0 || std::size_t(count) != bytes.size())
        return writeError(ErrorCode::WriteFailed, "the container could not be read back");
    return bytes;
}

} // namespace

Result<Bytes> writtenContainer(std::span<const StoredEntry> entries, const ContainerLimits &limits)
try {
    if (Result<void> checked = checkLimits(entries, limits); !checked)
        return checked.error();
    zip_error_t error;
    zip_error_init(&error);
    const std::unique_ptr<zip_source_t, void (*)(zip_source_t *)> target(
        zip_source_buffer_create(nullptr, 0, 0, &error), zip_source_free);
    zip_t *opened = target ? zip_open_from_source(target.get(), ZIP_CREATE | ZIP_TRUNCATE, &error) : nullptr;
    const std::string reason = opened ? std::string() : zip_error_strerror(&error);
    zip_error_fini(&error);
    if (!opened)
        return writeError(ErrorCode::WriteFailed, reason);
    zip_source_keep(target.get()); // closing the archive gives up one reference
    std::unique_ptr<zip_t, void (*)(zip_t *)> zip(opened, zip_discard);

    const StoredEntry mimeType = storedEntry("mimetype", asBytes(ductusMimeType));
    if (Result<void> added = addEntry(zip.get(), mimeType); !added)
        return added.error();
    for (const StoredEntry &entry : entries) {
        if (Result<void> added = addEntry(zip.get(), entry); !added)
            return added.error();
    }
    if (zip_close(zip.get()) != 0)
        return writeError(ErrorCode::WriteFailed, zip_strerror(zip.get()));
    static_cast<void>(zip.release()); // closed and freed
    return contentOf(target.get());
} catch (const std::bad_alloc &) {
    return writeError(ErrorCode::TooLarge, "there is not enough memory to write the project");
}

} // namespace ductus
