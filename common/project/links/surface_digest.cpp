#include "project/links/surface_digest.h"

#include "base/sha256.h"

#include <bit>

namespace ductus {

namespace {

// Little endian, as buffers of a project are, so that the same surface has the same digest everywhere.
template <typename T>
void add(Sha256 &sha, T value)
{
    std::array<std::byte, sizeof(T)> bytes;
    for (std::size_t i = 0; i < sizeof(T); ++i)
        bytes[i] = std::byte(std::uint8_t(value >> (8 * i)));
    sha.add(bytes);
}

} // namespace

std::string surfaceDigest(const StoredSurface &surface)
{
    Sha256 sha;
    add(sha, std::uint64_t(surface.mesh.vertices.size()));
    for (const Vec3 &vertex : surface.mesh.vertices)
        for (int i = 0; i < 3; ++i)
            add(sha, std::bit_cast<std::uint64_t>(vertex[i]));
    for (const Triangle &triangle : surface.mesh.triangles)
        for (const int corner : triangle)
            add(sha, std::uint32_t(corner));
    return sha.hexDigest();
}

} // namespace ductus
