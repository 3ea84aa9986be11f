// Marks of a doodle as JSON.
#pragma once

#include "doodling/canvas/doodle.h"
#include "project/arrays/array_loader.h"
#include "project/arrays/buffer_packer.h"

namespace ductus {

/// Arrays go through two passes: added when \a packer is open, named when it is finished, in the same order.
class ArrayPass
{
public:
    /// First pass: collects handles.
    ArrayPass(BufferPacker &packer, std::vector<BufferPacker::Handle> &handles)
        : mPacker(&packer), mFinished(&packer), mHandles(&handles)
    {
    }
    /// Second pass: spends them.
    ArrayPass(const BufferPacker &packer, const std::vector<BufferPacker::Handle> &handles)
        : mFinished(&packer), mSpent(&handles)
    {
    }

    template <typename T>
    OrderedJson array(std::span<const T> values, std::vector<std::uint64_t> shape, const char *unit = "")
    {
        if (mPacker) {
            mHandles->push_back(mPacker->add<T>(values, std::move(shape), unit));
            return {};
        }
        return mFinished->reference((*mSpent)[mNext++]).toJson();
    }

private:
    BufferPacker *mPacker = nullptr;
    const BufferPacker *mFinished;
    std::vector<BufferPacker::Handle> *mHandles = nullptr;
    const std::vector<BufferPacker::Handle> *mSpent = nullptr;
    std::size_t mNext = 0;
};

/// n x 2 numbers.
OrderedJson planePoints(const std::vector<Vec2> &points, const char *unit, ArrayPass &pass);
std::vector<Vec2> planePointsFrom(const JsonReader &reader, std::string_view key, ArrayLoader &arrays);

/// Null where a picture cannot be encoded, which memory alone can cause.
OrderedJson markJson(const DoodleMark &mark, ArrayPass &pass);
/// Fails through \a reader.
DoodleMark markFromJson(const JsonReader &reader, ArrayLoader &arrays);

} // namespace ductus
