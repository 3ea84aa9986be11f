// What must hold for any bytes at all: a reader gives a value without broken promises, or an Error that says
// something. Each check tells whether the bytes were accepted. Used by the libFuzzer programs and by the
// everyday test.
#pragma once

#include "base/assert.h"
#include "formats/mesh_file.h"
#include "formats/meshes/mesh_formats.h"
#include "formats/paintings/painting_readers.h"
#include "formats/png_file.h"
#include "formats/sketch_file.h"

namespace ductus {

inline void checkError(const Error &error)
{
    DUCTUS_ASSERT(!error.attempted.empty());
    DUCTUS_ASSERT(!error.problem.empty());
}

inline bool checkSketchReader(std::string_view bytes, const std::string &name)
{
    const auto file = parseSketch(bytes, name, {}, {});
    if (!file) {
        checkError(file.error());
        return false;
    }
    DUCTUS_ASSERT(!file->strokes.strokes.empty());
    std::size_t points = 0;
    for (std::size_t s = 0; s < file->strokes.strokes.size(); ++s) {
        const Stroke &stroke = file->strokes.strokes[s];
        DUCTUS_ASSERT(stroke.id.value == int(s));
        DUCTUS_ASSERT(stroke.points.size() >= (file->isPointCloud ? 1u : 2u));
        points += stroke.points.size();
        for (const Vec3 &p : stroke.points)
            DUCTUS_ASSERT(p.allFinite());
    }
    DUCTUS_ASSERT(points <= bytes.size() + 1);
    return true;
}

inline bool checkMeshReader(std::string_view bytes, const std::string &name)
{
    const auto mesh = parseMesh(bytes, name, {});
    if (!mesh) {
        checkError(mesh.error());
        return false;
    }
    DUCTUS_ASSERT(!mesh->isEmpty());
    for (const Vec3 &v : mesh->vertices)
        DUCTUS_ASSERT(v.allFinite());
    for (const Triangle &t : mesh->triangles)
        for (const int v : t)
            DUCTUS_ASSERT(v >= 0 && v < mesh->vertexCount());
    // What was read can be written, and comes back.
    const auto written = meshBytes({*mesh, {}, {}, "", {}, {}}, ".ply", {});
    DUCTUS_ASSERT(written.ok());
    const auto again = parseMesh(*written, "again.ply", {});
    DUCTUS_ASSERT(again.ok() && again->vertices == mesh->vertices && again->triangles == mesh->triangles);
    return true;
}

inline bool checkColouredMeshReader(std::string_view bytes, const std::string &name)
{
    const auto read = readColouredGlbMesh(bytes, name, {});
    if (!read) {
        checkError(read.error());
        return false;
    }
    const auto &[mesh, colours] = *read;
    DUCTUS_ASSERT(colours.empty() || colours.size() == mesh.vertices.size());
    for (const Eigen::Vector4f &colour : colours)
        DUCTUS_ASSERT(colour.minCoeff() >= 0.f && colour.maxCoeff() <= 1.f);
    for (const Triangle &t : mesh.triangles)
        for (const int v : t)
            DUCTUS_ASSERT(v >= 0 && v < mesh.vertexCount());
    MeshFileContent content;
    content.mesh = mesh;
    content.vertexColours = colours;
    // Coordinates beyond the range of 32 bits are the writer's to refuse or round; it must not break.
    (void)meshBytes(content, ".glb", {});
    return true;
}

/// The bytes with the checksum of every PNG chunk made right, so that damage reaches what lies behind the
/// checksum.
inline std::string withRightChecksums(std::string_view png)
{
    std::string bytes(png);
    for (std::size_t at = 8; at + 12 <= bytes.size();) {
        std::uint32_t size = 0;
        for (std::size_t k = 0; k < 4; ++k)
            size = size << 8 | std::uint8_t(bytes[at + k]);
        if (size > bytes.size() - at - 12)
            break;
        std::uint32_t crc = 0xffffffff; // CRC-32 of ISO 3309, over type and content
        for (std::size_t i = at + 4; i < at + 8 + size; ++i) {
            crc ^= std::uint8_t(bytes[i]);
            for (int bit = 0; bit < 8; ++bit)
                crc = crc >> 1 ^ (crc & 1 ? 0xedb88320 : 0);
        }
        for (std::size_t k = 0; k < 4; ++k)
            bytes[at + 8 + size + k] = char(~crc >> (24 - 8 * k));
        at += 12 + std::size_t(size);
    }
    return bytes;
}

inline bool checkPngReader(std::string_view bytes)
{
    const auto image = decodePng(std::as_bytes(std::span(bytes)));
    if (!image) {
        checkError(image.error());
        return false;
    }
    DUCTUS_ASSERT(image->width > 0 && image->height > 0);
    DUCTUS_ASSERT(image->pixels.size() == std::size_t(image->width) * std::size_t(image->height) * 4);
    return true;
}

/// What every painting promises, whatever it was read from.
inline void checkPainting(const PaintingFile &file, std::size_t fileBytes)
{
    DUCTUS_ASSERT(!file.layers.empty() && file.layers[0].parent == -1);
    std::int64_t points = 0;
    for (std::size_t l = 0; l < file.layers.size(); ++l) {
        const PaintingFileLayer &layer = file.layers[l];
        DUCTUS_ASSERT(l == 0 || (layer.parent >= 0 && layer.parent < int(l)));
        DUCTUS_ASSERT(layer.opacity >= 0 && layer.opacity <= 1);
        DUCTUS_ASSERT(layer.transform.matrix().matrix().allFinite());
        for (const int frame : layer.frames)
            DUCTUS_ASSERT(frame >= 0 && frame < int(layer.drawings.size()));
        for (const auto &drawing : layer.drawings) {
            DUCTUS_ASSERT(drawing);
            for (const PaintingFileStroke &stroke : drawing->strokes) {
                points += std::int64_t(stroke.points.size());
                DUCTUS_ASSERT(stroke.pressure.empty() || stroke.pressure.size() == stroke.points.size());
                DUCTUS_ASSERT(stroke.timeSeconds.empty() ||
                              stroke.timeSeconds.size() == stroke.points.size());
                for (const PaintingFilePoint &point : stroke.points) {
                    DUCTUS_ASSERT(point.position.allFinite() && point.normal.allFinite());
                    DUCTUS_ASSERT(point.colour.minCoeff() >= 0 && point.colour.maxCoeff() <= 1);
                    DUCTUS_ASSERT(point.opacity >= 0 && point.opacity <= 1 && point.halfWidth >= 0);
                }
            }
        }
    }
    DUCTUS_ASSERT(file.report.points <= std::int64_t(fileBytes));
    DUCTUS_ASSERT(points >= file.report.points); // layers may share a drawing
}

inline bool checkQuillReader(std::string_view bytes)
{
    const std::size_t split = std::min(bytes.find('\0'), bytes.size());
    const auto json = memorySource(bytes.substr(0, split), "Quill.json");
    const auto qbin = memorySource(bytes.substr(std::min(split + 1, bytes.size())), "Quill.qbin");
    const auto file = readQuill(*json, qbin.get(), {}, {});
    if (!file) {
        checkError(file.error());
        return false;
    }
    checkPainting(*file, bytes.size());
    return true;
}

/// \a bytes as the data.sketch of a .tilt with two brushes.
inline bool checkTiltReader(std::string_view bytes)
{
    const auto sketch = memorySource(bytes, "data.sketch");
    const auto metadata = memorySource("{\"BrushIndex\":[\"a\",\"b\"]}", "metadata.json");
    const auto file = readTilt(*sketch, metadata.get(), {}, {});
    if (!file) {
        checkError(file.error());
        return false;
    }
    checkPainting(*file, bytes.size());
    return true;
}

} // namespace ductus
