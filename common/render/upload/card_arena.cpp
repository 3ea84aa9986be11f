#include "render/upload/card_arena.h"

#include "render/gl/gl_error.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace ductus {

Result<CardRange> CardArena::take(std::uint32_t count)
{
    if (count == 0)
        return CardRange{};
    for (int attempt = 0; attempt < 2; ++attempt) {
        for (auto gap = mFree.begin(); gap != mFree.end(); ++gap) {
            if (gap->second < count)
                continue;
            const CardRange range{gap->first, count};
            const std::uint32_t left = gap->second - count;
            mFree.erase(gap);
            if (left > 0)
                mFree.emplace(range.first + count, left);
            return range;
        }
        const std::uint64_t wanted = std::max<std::uint64_t>(
            {std::uint64_t(mCapacity) + count, std::uint64_t(mCapacity) * 3 / 2, 1024});
        if (Result<void> grown = grow(wanted); !grown)
            return grown.error();
    }
    return Error{ErrorCode::TooLarge,
                 "Uploading the painting",
                 "the graphics card has no room for the strokes",
                 "Hide layers or reduce the painting",
                 {}};
}

void CardArena::give(const CardRange &range)
{
    if (range.count == 0)
        return;
    auto gap = mFree.emplace(range.first, range.count).first;
    const auto after = std::next(gap);
    if (after != mFree.end() && gap->first + gap->second == after->first) {
        gap->second += after->second;
        mFree.erase(after);
    }
    if (gap != mFree.begin()) {
        const auto before = std::prev(gap);
        if (before->first + before->second == gap->first) {
            before->second += gap->second;
            mFree.erase(gap);
        }
    }
}

void CardArena::write(const CardRange &range, const void *data)
{
    if (range.count == 0)
        return;
    const std::size_t bytes = range.count * mPieceSize;
    glBindBuffer(GL_COPY_WRITE_BUFFER, mBuffer.name());
    glBufferSubData(GL_COPY_WRITE_BUFFER, GLintptr(range.first * mPieceSize), GLsizeiptr(bytes), data);
    mBytesWritten += bytes;
}

Result<void> CardArena::grow(std::uint64_t capacity)
{
    if (capacity > std::numeric_limits<std::uint32_t>::max())
        return Error{ErrorCode::TooLarge,
                     "Uploading the painting",
                     "the painting has too many points",
                     "Reduce the painting",
                     {}};
    GlBuffer larger = GlBuffer::create();
    glBindBuffer(GL_COPY_WRITE_BUFFER, larger.name());
    glBufferData(GL_COPY_WRITE_BUFFER, GLsizeiptr(capacity * mPieceSize), nullptr, GL_DYNAMIC_DRAW);
    if (Result<void> room = checkGl("Uploading the painting"); !room)
        return room;
    if (mCapacity > 0) {
        glBindBuffer(GL_COPY_READ_BUFFER, mBuffer.name());
        glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0,
                            GLsizeiptr(mCapacity * mPieceSize));
    }
    const CardRange added{mCapacity, std::uint32_t(capacity) - mCapacity};
    mBuffer = std::move(larger);
    mCapacity = std::uint32_t(capacity);
    give(added);
    return {};
}

} // namespace ductus
