#include "seeds.h"

#include "formats/mesh_file.h"
#include "formats/png_file.h"
#include "support/quill_sample.h"
#include "support/tilt_sample.h"

namespace ductus {

namespace {

std::vector<Seed> meshSeeds()
{
    MeshFileContent content;
    content.mesh.vertices = {{0, 0, 0}, {1.5, 0, 0}, {0, 1, 0.25}, {0, -0.125, 1}};
    content.mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    content.triangleRegions = {0, 0, 1, 2};
    content.featureLines = {{0, 1, 2}};
    std::vector<Seed> seeds;
    for (const char *extension : {".obj", ".ply", ".stl", ".off", ".glb"})
        seeds.push_back({Seed::Mesh, std::string("seed") + extension, *meshBytes(content, extension, {})});
    content.vertexColours.assign(4, {0.5f, 0.25f, 1, 0.75f});
    content.regionNames = {"a", "b", "c"};
    seeds.push_back({Seed::Mesh, "seed_coloured.glb", *meshBytes(content, ".glb", {})});
    seeds.push_back(
        {Seed::Mesh, "seed_ascii.stl",
         "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
         "endfacet\nendsolid s\n"});
    seeds.push_back(
        {Seed::Mesh, "seed_ascii.ply",
         "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 2\nproperty uchar red\nproperty list uchar int vertex_indices\nelement edge 1\n"
         "property int vertex1\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n7 3 0 1 2\n7 4 0 1 2 3\n5\n"});
    std::string bigEndian =
        "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty uchar x\nproperty uchar "
        "y\nproperty uchar z\nelement face 1\nproperty list uchar uchar vertex_index\nend_header\n";
    seeds.push_back({Seed::Mesh, "seed_big.ply", bigEndian + std::string("\0\0\0\1\0\0\0\1\0\3\0\1\2", 13)});
    return seeds;
}

} // namespace

std::vector<Seed> fuzzSeeds()
{
    std::vector<Seed> seeds = meshSeeds();
    seeds.push_back({Seed::Sketch, "seed.curves", "v 3\n0.1 2 -3e-2\n1 2 3\n4 5 6\nv 2\n7 8 9\n1 1 1\n"});
    seeds.push_back(
        {Seed::Sketch, "seed.obj",
         "# c\ng\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 2 0 0\nv 1 -1 0\ng x\nl 2 1\nl 3 2\nl 2 4\nl -1 2\n"});
    seeds.push_back({Seed::Sketch, "seed_long.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3 1\nl -3/1 -2/2\n"});
    seeds.push_back({Seed::Sketch, "seed.txt", "CURVE 0\n0 0 0\n1 0 0\nCURVE 1\n1 1 1\n2 2 2.5\n"});
    std::string cloud;
    for (int i = 0; i < 20; ++i)
        cloud += std::to_string(i * 7 % 20) + " 0 " + std::to_string(i * 3 % 20) + "\n";
    seeds.push_back({Seed::Sketch, "seed.xyz", cloud});
    seeds.push_back({Seed::Sketch, "seed_blocks.xyz", "0 0 0\n1 1 1\n\n2 2 2 0 0 1\n3 3 3 0 0 1\n"});
    Image image(5, 3, {10, 20, 30, 200});
    image.set(2, 1, {255, 0, 128, 7});
    const auto png = *encodePng(image);
    seeds.push_back(
        {Seed::Png, "seed.png", std::string(reinterpret_cast<const char *>(png.data()), png.size())});
    const QuillSample quill = quillSample();
    seeds.push_back({Seed::Quill, "seed_quill", quill.json + '\0' + quill.qbin});
    seeds.push_back({Seed::Tilt, "seed_tilt", tiltSketch()});
    return seeds;
}

} // namespace ductus
