// How the painting's buffers are read: the vertex arrays of PaintingUpload.
#include "render/upload/mesh_vertex.h"
#include "render/upload/painting_upload.h"

#include <array>
#include <cstddef>

namespace ductus {

namespace {

void setAttribute(GLuint index, GLint size, GLenum type, std::size_t stride, std::size_t offset,
                  GLuint divisor)
{
    const void *at = reinterpret_cast<const void *>(offset);
    glEnableVertexAttribArray(index);
    glVertexAttribDivisor(index, divisor);
    if (type == GL_UNSIGNED_INT)
        glVertexAttribIPointer(index, size, type, GLsizei(stride), at);
    else
        glVertexAttribPointer(index, size, type, type == GL_SHORT, GLsizei(stride), at);
}

/// Arrays are told their buffer anew each time: it moves when it grows.
GlVertexArray &beginArray(GlVertexArray &array, GLuint buffer)
{
    if (!array)
        array = GlVertexArray::create();
    glBindVertexArray(array.name());
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    return array;
}

} // namespace

void PaintingUpload::addBoxIndices()
{
    // Corner x + 2 y + 4 z; counter-clockwise from outside.
    static constexpr std::array<std::uint16_t, boxIndexCount + cardIndexCount> indices{
        0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4,
        7, 6,
        // A card, seen from behind as the boxes' inner sides are.
        8, 9, 11, 8, 11, 10};
    const bool isNew = !mBoxIndices;
    if (isNew)
        mBoxIndices = GlBuffer::create();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, mBoxIndices.name());
    if (isNew)
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices.data(), GL_STATIC_DRAW);
}

GLuint PaintingUpload::segmentArray(bool coarse, bool withReach)
{
    GlVertexArray &array =
        beginArray(withReach ? mReachArray : mSegmentArray, (coarse ? mCoarse : mSegments).buffer());
    addBoxIndices();
    constexpr std::size_t stride = sizeof(SegmentInstance);
    setAttribute(0, 4, GL_FLOAT, stride, offsetof(SegmentInstance, a), 1);
    setAttribute(1, 4, GL_FLOAT, stride, offsetof(SegmentInstance, b), 1);
    setAttribute(2, 4, GL_SHORT, stride, offsetof(SegmentInstance, u), 1);
    setAttribute(3, 4, GL_SHORT, stride, offsetof(SegmentInstance, v), 1);
    setAttribute(4, 4, GL_SHORT, stride, offsetof(SegmentInstance, clipA), 1);
    setAttribute(5, 4, GL_SHORT, stride, offsetof(SegmentInstance, clipB), 1);
    setAttribute(6, 4, GL_HALF_FLOAT, stride, offsetof(SegmentInstance, colourA), 1);
    setAttribute(7, 4, GL_HALF_FLOAT, stride, offsetof(SegmentInstance, colourB), 1);
    setAttribute(8, 1, GL_UNSIGNED_INT, stride, offsetof(SegmentInstance, element), 1);
    if (withReach) {
        glBindBuffer(GL_ARRAY_BUFFER, mReach.name());
        setAttribute(9, 4, GL_SHORT, sizeof(ReachInstance), offsetof(ReachInstance, a), 1);
        setAttribute(10, 4, GL_SHORT, sizeof(ReachInstance), offsetof(ReachInstance, b), 1);
    }
    return array.name();
}

GLuint PaintingUpload::meshArray()
{
    GlVertexArray &array = beginArray(mMeshArray, mTriangles.buffer());
    setAttribute(0, 3, GL_FLOAT, sizeof(MeshVertex), offsetof(MeshVertex, position), 0);
    setAttribute(1, 4, GL_HALF_FLOAT, sizeof(MeshVertex), offsetof(MeshVertex, colour), 0);
    setAttribute(2, 1, GL_UNSIGNED_INT, sizeof(MeshVertex), offsetof(MeshVertex, element), 0);
    return array.name();
}

GLuint PaintingUpload::triangleArray()
{
    GlVertexArray &array = beginArray(mTriangleArray, mTriangles.buffer());
    addBoxIndices();
    for (GLuint corner = 0; corner < 3; ++corner)
        setAttribute(corner, 3, GL_FLOAT, 3 * sizeof(MeshVertex),
                     corner * sizeof(MeshVertex) + offsetof(MeshVertex, position), 1);
    setAttribute(3, 1, GL_UNSIGNED_INT, 3 * sizeof(MeshVertex), offsetof(MeshVertex, element), 1);
    return array.name();
}

} // namespace ductus
