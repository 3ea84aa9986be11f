#include "render/upload/mesh_vertex.h"

namespace ductus {

std::vector<MeshVertex> verticesOf(const MeshShape &shape, std::uint32_t element)
{
    const auto half = [](float x) { return Eigen::numext::bit_cast<std::uint16_t>(Eigen::half(x)); };
    std::vector<MeshVertex> vertices;
    vertices.reserve(shape.mesh.triangles.size() * 3);
    for (const Triangle &triangle : shape.mesh.triangles)
        for (const int corner : triangle) {
            const Eigen::Vector3f p = shape.mesh.vertices[std::size_t(corner)].cast<float>();
            const Eigen::Vector3f &c = shape.vertexColours[std::size_t(corner)];
            vertices.push_back({{p[0], p[1], p[2]}, {half(c[0]), half(c[1]), half(c[2]), half(1)}, element});
        }
    return vertices;
}

Eigen::Vector3f meanColourOf(const MeshShape &shape)
{
    Eigen::Vector3f mean = Eigen::Vector3f::Zero();
    for (const Eigen::Vector3f &colour : shape.vertexColours)
        mean += colour / float(shape.vertexColours.size());
    return mean;
}

} // namespace ductus
