// The ribbons of a layer's strokes, in chunks of neighbours in drawing order. In each chunk they are
// shuffled, so that the first few stand for all of them.
#pragma once

#include "render/upload/card_arena.h"
#include "render/upload/ribbon_vertex.h"

#include <map>
#include <memory>
#include <span>

namespace ductus {

struct DrawnLayer;

struct RibbonChunk
{
    std::size_t firstElement = 0, elementCount = 0; // of DrawnLayer::elements
    std::uint64_t signature = 0;
    CardRange vertices;
    std::vector<std::uint32_t> ends; // vertices of the first 1, 2, ... strokes
    // Ball around them and the strokes' size, scene units:
    Vec3 centre = Vec3::Zero();
    double radius = 0;
    double widest = 0;   // half width
    double meanArea = 0; // seen from the side
    bool hasMeshes = false;
};

class RibbonChunks
{
public:
    static constexpr std::size_t strokesPerChunk = 64;

    /// Brings the chunks of a layer up to date; TooLarge when the card has no room.
    Result<void> update(const DrawnLayer &layer);
    /// Forgets the layers that are not among \a layers.
    void keepOnly(std::span<const DrawnLayer *const> layers);
    const std::vector<RibbonChunk> &chunksOf(const DrawnLayer &layer) const;
    /// Vertex array with the current buffer, bound.
    GLuint array();

private:
    Result<void> fill(const DrawnLayer &layer, RibbonChunk &chunk);

    CardArena mVertices{sizeof(RibbonVertex)};
    GlVertexArray mArray;
    std::map<std::int32_t, std::vector<RibbonChunk>> mChunks; // by layer id
    std::vector<RibbonChunk> mNone;
};

} // namespace ductus
