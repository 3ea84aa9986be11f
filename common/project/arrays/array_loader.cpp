#include "project/arrays/array_loader.h"

#include "base/sha256.h"
#include "project/container/entry_name.h"

namespace ductus {

ArrayLoader::ArrayLoader(const BufferStore &store, std::string fileName)
    : mStore(store), mFileName(std::move(fileName))
{
}

const Bytes *ArrayLoader::buffer(const JsonReader &reader, const std::string &hash)
{
    if (const auto found = mUnpacked.find(hash); found != mUnpacked.end())
        return &found->second;
    const StoredEntry *entry = mStore.find(hash);
    if (!entry) {
        reader.failAt("buffer", "the project does not hold this buffer");
        return nullptr;
    }
    Result<Bytes> bytes = unpacked(*entry, mFileName + ":" + entry->name);
    if (!bytes) {
        reader.failAt("buffer", bytes.error().problem + " (" + entry->name + ")", bytes.error().code);
        return nullptr;
    }
    if (sha256Hex(*bytes) != hash) {
        reader.failAt("buffer",
                      "the content of " + entry->name + " does not match its name, the file is damaged");
        return nullptr;
    }
    mUsed.insert(hash);
    return &mUnpacked.emplace(hash, std::move(*bytes)).first->second;
}

std::span<const std::byte> ArrayLoader::locate(const JsonReader &parent, std::string_view key, ArrayType type,
                                               std::uint64_t columns)
{
    if (parent.failed())
        return {};
    const JsonReader reader = parent.member(key);
    const ArrayReference reference = reader.failed() ? ArrayReference() : ArrayReference::fromJson(reader);
    if (reader.failed())
        return {};
    if (reference.type != type) {
        reader.failAt("type", "the array must be of type " + std::string(arrayTypeName(type)));
        return {};
    }
    const bool shapeFits = columns == 1 ? reference.shape.size() == 1
                                        : reference.shape.size() == 2 && reference.shape[1] == columns;
    const std::optional<std::uint64_t> count = reference.count();
    std::uint64_t byteCount = 0;
    if (!shapeFits || !count || __builtin_mul_overflow(*count, elementSize(type), &byteCount)) {
        reader.failAt("shape", columns == 1 ? "the shape must be [n]"
                                            : "the shape must be [n, " + std::to_string(columns) + "]");
        return {};
    }
    const Bytes *bytes = buffer(reader, reference.buffer);
    if (!bytes)
        return {};
    if (reference.offset > bytes->size() || byteCount > bytes->size() - reference.offset) {
        reader.failAt("shape", "the array ends beyond its buffer");
        return {};
    }
    // Many arrays may share one buffer, so what they unpack to together needs a bound of its own.
    mLoadedBytes += byteCount;
    if (mLoadedBytes > ContainerLimits().maxArrayBytes) {
        reader.fail("the arrays of this project are too large", ErrorCode::TooLarge);
        return {};
    }
    return std::span(*bytes).subspan(reference.offset, byteCount);
}

} // namespace ductus
