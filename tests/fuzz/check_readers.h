// What must hold for any bytes at all: a reader gives a value without broken promises, or an Error that says
// something. Each check tells whether the bytes were accepted. Used by the libFuzzer programs and by the
// everyday test.
#pragma once

#include "base/assert.h"
#include "formats/mesh_file.h"
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
    const auto written = meshBytes({*mesh, {}, {}, ""}, ".ply", {});
    DUCTUS_ASSERT(written.ok());
    const auto again = parseMesh(*written, "again.ply", {});
    DUCTUS_ASSERT(again.ok() && again->vertices == mesh->vertices && again->triangles == mesh->triangles);
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

} // namespace ductus
