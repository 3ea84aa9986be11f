// A growing buffer on the graphics card, given out in ranges of equal pieces.
#pragma once

#include "base/result.h"
#include "render/gl/gl_object.h"

#include <cstdint>
#include <map>

namespace ductus {

struct CardRange
{
    std::uint32_t first = 0; // pieces
    std::uint32_t count = 0;
};

class CardArena
{
public:
    explicit CardArena(std::size_t bytesPerPiece) : mPieceSize(bytesPerPiece) {}

    /// TooLarge when the card has no room. Ranges asked for one after the other follow each other where they
    /// can.
    Result<CardRange> take(std::uint32_t count);
    void give(const CardRange &range);

    /// \a data: range.count pieces.
    void write(const CardRange &range, const void *data);

    GLuint buffer() const { return mBuffer.name(); }
    std::uint32_t capacity() const { return mCapacity; }
    /// Since the arena was made.
    std::uint64_t bytesWritten() const { return mBytesWritten; }

private:
    Result<void> grow(std::uint64_t capacity);

    std::size_t mPieceSize;
    GlBuffer mBuffer;
    std::uint32_t mCapacity = 0;
    std::map<std::uint32_t, std::uint32_t> mFree; // first -> count, no neighbours
    std::uint64_t mBytesWritten = 0;
};

} // namespace ductus
