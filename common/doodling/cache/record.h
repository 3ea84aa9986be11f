// Numbers and arrays one after the other in a file of their own, with a sum that tells damage. They are read
// where they lie, in the order they were written.
//
//     RecordWriter writer;
//     writer.add<double>({4.0, 10.0});
//     writer.add<std::uint8_t>(confidences);
//     writer.write(path);
//     RecordReader reader(MappedFile::open(path));
//     if (const auto sizes = reader.array<double>(2)) ...
#pragma once

#include "doodling/cache/mapped_file.h"
#include "doodling/cache/shared_array.h"

#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

namespace ductus {

class RecordWriter
{
public:
    RecordWriter();

    template <typename T>
    void add(std::span<const T> values)
    {
        addBytes(std::as_bytes(values));
    }
    void addNumbers(std::initializer_list<double> numbers)
    {
        add(std::span<const double>(numbers.begin(), numbers.size()));
    }

    /// Beside \a path first, then in its place. Not forced to the disk: what a crash leaves half written is
    /// known by its sum.
    Result<void> write(const std::filesystem::path &path) const;

private:
    void addBytes(std::span<const std::byte> bytes);

    std::vector<std::byte> mBytes; // the head is filled in by write
};

class RecordReader
{
public:
    /// \a file null: nothing is read.
    explicit RecordReader(std::shared_ptr<const MappedFile> file);

    /// The whole record is as it was written. Reads all of it.
    bool isSound() const;

    /// The next array; empty and failed() if it is none of \a count such values.
    template <typename T>
    SharedArray<T> array(std::size_t count)
    {
        const std::optional<std::span<const std::byte>> bytes = next();
        if (!bytes || bytes->size() != count * sizeof(T)) {
            mIsFailed = true;
            return {};
        }
        return {std::span<const T>(reinterpret_cast<const T *>(bytes->data()), count), mFile};
    }
    /// The next array of numbers, however many there are.
    std::vector<double> numbers();

    bool failed() const { return mIsFailed; }
    bool isAtEnd() const;
    const std::shared_ptr<const MappedFile> &file() const { return mFile; }

private:
    std::optional<std::span<const std::byte>> next();

    std::shared_ptr<const MappedFile> mFile;
    std::size_t mAt = 0;
    bool mIsFailed = false;
};

} // namespace ductus
