// The shapes of a painting in blocks of columns. Elements name their shape by its number, so that duplicates
// share it; a block holds shapes of one drawing, so that a change of one drawing rewrites its blocks alone.
#pragma once

#include "painting/storage/painting_content.h"

#include <unordered_map>

namespace ductus {

class ShapeBlockWriter
{
public:
    ShapeBlockWriter(BufferPacker &packer, const UnknownPaintingMembers &unknown)
        : mPacker(packer), mUnknown(unknown)
    {
    }

    /// The shapes of \a drawing that were not there yet, as blocks of their own.
    void add(const Drawing &drawing);
    /// The number of an added shape.
    int numberOf(const ElementShape &shape) const { return mNumbers.at(&shape); }
    /// An array of all blocks, with array slots.
    OrderedJson takeBlocks() { return std::move(mBlocks); }

private:
    void addStrokes(const std::vector<const StrokeShape *> &strokes);
    void addMesh(const MeshShape &mesh);

    BufferPacker &mPacker;
    const UnknownPaintingMembers &mUnknown;
    std::unordered_map<const ElementShape *, int> mNumbers;
    OrderedJson mBlocks = OrderedJson::array();
};

/// All shapes by number; what is wrong is told through \a reader.
std::vector<std::shared_ptr<const ElementShape>> readShapeBlocks(const JsonReader &reader,
                                                                 std::string_view key, ArrayLoader &arrays,
                                                                 UnknownPaintingMembers &unknown);

} // namespace ductus
