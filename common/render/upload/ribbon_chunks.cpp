#include "render/upload/ribbon_chunks.h"

#include "base/random.h"
#include "render/upload/painting_upload.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace ductus {

namespace {

/// More are no better to look at where a stroke is a few pixels wide.
constexpr std::size_t mostPlaces = 4;

std::uint64_t mixed(std::uint64_t hash, std::uint64_t value) // FNV-1a on words
{
    return (hash ^ value) * 1099511628211ull;
}

double lengthOf(const StrokeShape &stroke)
{
    double length = 0;
    for (std::size_t i = 1; i < stroke.points.size(); ++i)
        length += double((stroke.points[i].position - stroke.points[i - 1].position).norm());
    return length;
}

void setAttribute(GLuint index, GLint size, GLenum type, bool isFraction, std::size_t offset)
{
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, size, type, isFraction, sizeof(RibbonVertex),
                          reinterpret_cast<const void *>(offset));
}

} // namespace

Result<void> RibbonChunks::update(const DrawnLayer &layer)
{
    std::vector<RibbonChunk> &chunks = mChunks[layer.id.value];
    const std::size_t wanted = (layer.elements.size() + strokesPerChunk - 1) / strokesPerChunk;
    for (std::size_t i = wanted; i < chunks.size(); ++i)
        mVertices.give(chunks[i].vertices);
    chunks.resize(wanted);
    for (std::size_t i = 0; i < wanted; ++i) {
        RibbonChunk &chunk = chunks[i];
        chunk.firstElement = i * strokesPerChunk;
        chunk.elementCount = std::min(strokesPerChunk, layer.elements.size() - chunk.firstElement);
        const std::span elements(layer.elements.data() + chunk.firstElement, chunk.elementCount);
        std::uint64_t signature = 14695981039346656037ull;
        Box3 box;
        chunk.widest = 0;
        chunk.hasMeshes = false;
        for (const DrawnElement &element : elements) {
            signature = mixed(mixed(signature, element.row), element.shapeVersion);
            box.add(element.centre - Vec3::Constant(element.radius));
            box.add(element.centre + Vec3::Constant(element.radius));
            chunk.widest = std::max(chunk.widest, element.widest);
            chunk.hasMeshes |= element.isMesh;
        }
        chunk.centre = box.centre();
        chunk.radius = 0.5 * box.diagonal();
        if (signature == chunk.signature)
            continue;
        chunk.signature = signature;
        if (Result<void> filled = fill(layer, chunk); !filled)
            return filled;
    }
    return {};
}

Result<void> RibbonChunks::fill(const DrawnLayer &layer, RibbonChunk &chunk)
{
    mVertices.give(chunk.vertices);
    chunk.vertices = {};
    chunk.ends.clear();
    std::vector<std::size_t> order(chunk.elementCount);
    std::iota(order.begin(), order.end(), chunk.firstElement);
    Random random(chunk.firstElement + 1);
    random.shuffle(order);

    std::vector<RibbonVertex> vertices;
    double area = 0;
    for (const std::size_t at : order) {
        const DrawnElement &element = layer.elements[at];
        const auto *stroke = std::get_if<StrokeShape>(element.shape);
        if (!stroke)
            continue;
        appendRibbon(*stroke, element.row, mostPlaces, vertices);
        chunk.ends.push_back(std::uint32_t(vertices.size()));
        area += 2 * element.widest * (lengthOf(*stroke) * element.scale + element.widest);
    }
    chunk.meanArea = area / double(std::max<std::size_t>(chunk.ends.size(), 1));
    const Result<CardRange> range = mVertices.take(std::uint32_t(vertices.size()));
    if (!range)
        return range.error();
    chunk.vertices = *range;
    mVertices.write(*range, vertices.data());
    return {};
}

void RibbonChunks::keepOnly(std::span<const DrawnLayer *const> layers)
{
    for (auto known = mChunks.begin(); known != mChunks.end();) {
        const bool stays = std::any_of(layers.begin(), layers.end(), [&](const DrawnLayer *layer) {
            return layer->id.value == known->first;
        });
        if (stays) {
            ++known;
            continue;
        }
        for (const RibbonChunk &chunk : known->second)
            mVertices.give(chunk.vertices);
        known = mChunks.erase(known);
    }
}

const std::vector<RibbonChunk> &RibbonChunks::chunksOf(const DrawnLayer &layer) const
{
    const auto found = mChunks.find(layer.id.value);
    return found == mChunks.end() ? mNone : found->second;
}

GLuint RibbonChunks::array()
{
    if (!mArray)
        mArray = GlVertexArray::create();
    glBindVertexArray(mArray.name());
    glBindBuffer(GL_ARRAY_BUFFER, mVertices.buffer()); // told anew each time: it moves when it grows
    setAttribute(0, 4, GL_FLOAT, false, offsetof(RibbonVertex, position));
    setAttribute(1, 4, GL_SHORT, true, offsetof(RibbonVertex, along));
    setAttribute(2, 4, GL_SHORT, true, offsetof(RibbonVertex, normal));
    setAttribute(3, 4, GL_UNSIGNED_BYTE, true, offsetof(RibbonVertex, colour));
    glEnableVertexAttribArray(4);
    glVertexAttribIPointer(4, 1, GL_UNSIGNED_INT, sizeof(RibbonVertex),
                           reinterpret_cast<const void *>(offsetof(RibbonVertex, element)));
    return mArray.name();
}

} // namespace ductus
