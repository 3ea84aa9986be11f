// Small meshes with known properties, sound and sick, for the tests of everything that reads a TriangleMesh.
#pragma once

#include "geometry/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace ductus::zoo {

/// Regular tetrahedron-like solid, outwards.
inline TriangleMesh tetrahedron(const Vec3 &offset = Vec3::Zero())
{
    TriangleMesh mesh;
    mesh.vertices = {offset, offset + Vec3(1, 0, 0), offset + Vec3(0, 1, 0), offset + Vec3(0, 0, 1)};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    return mesh;
}

/// Unit sphere; 20 * 4^level triangles.
inline TriangleMesh icosphere(int level)
{
    const double g = std::numbers::phi;
    TriangleMesh mesh;
    mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                     {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    for (Vec3 &v : mesh.vertices)
        v.normalize();
    mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (int i = 0; i < level; ++i) {
        std::map<std::pair<int, int>, int> middles;
        const auto middle = [&](int a, int b) {
            const auto [at, isNew] =
                middles.try_emplace({std::min(a, b), std::max(a, b)}, mesh.vertexCount());
            if (isNew)
                mesh.vertices.push_back(Vec3((mesh.vertices[a] + mesh.vertices[b]).normalized()));
            return at->second;
        };
        std::vector<Triangle> finer;
        for (const auto &[a, b, c] : mesh.triangles) {
            const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        mesh.triangles = finer;
    }
    return mesh;
}

/// Axis-aligned box from \a low to \a high, 12 triangles, outwards.
inline TriangleMesh box(const Vec3 &low = Vec3::Zero(), const Vec3 &high = Vec3::Ones())
{
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.push_back(
            {i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z()});
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

/// Around the Z axis, outwards; 2 * around * across triangles.
inline TriangleMesh torus(double major = 1.0, double minor = 0.35, int around = 48, int across = 20)
{
    TriangleMesh mesh;
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            const double u = 2.0 * std::numbers::pi * i / around;
            const double v = 2.0 * std::numbers::pi * j / across;
            const double r = major + minor * std::cos(v);
            mesh.vertices.push_back({r * std::cos(u), r * std::sin(u), minor * std::sin(v)});
            const int a = i * across + j, b = (i + 1) % around * across + j;
            const int c = (i + 1) % around * across + (j + 1) % across, d = i * across + (j + 1) % across;
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
        }
    }
    return mesh;
}

/// n x n cells over the unit square, lifted to z = height sin(pi x) sin(pi y); normals up, with a border.
inline TriangleMesh grid(int n, double height = 0.0)
{
    TriangleMesh mesh;
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            const double x = double(i) / n, y = double(j) / n;
            mesh.vertices.push_back(
                {x, y, height * std::sin(std::numbers::pi * x) * std::sin(std::numbers::pi * y)});
            if (i == n || j == n)
                continue;
            const int a = j * (n + 1) + i, c = a + n + 2;
            mesh.triangles.push_back({a, a + 1, c});
            mesh.triangles.push_back({a, c, a + n + 1});
        }
    }
    return mesh;
}

/// One-sided strip, \a width cells wide; cannot be oriented.
inline TriangleMesh moebiusStrip(int cells = 24, int width = 2)
{
    TriangleMesh mesh;
    for (int i = 0; i < cells; ++i) {
        const double u = 2.0 * std::numbers::pi * i / cells;
        for (int j = 0; j <= width; ++j) {
            const double s = 0.6 * (double(j) / width - 0.5);
            const double r = 1.0 + s * std::cos(0.5 * u);
            mesh.vertices.push_back({r * std::cos(u), r * std::sin(u), s * std::sin(0.5 * u)});
        }
        for (int j = 0; j < width; ++j) {
            const bool last = i + 1 == cells;
            const auto at = [&](int k) { return last ? width - k : (i + 1) * (width + 1) + k; };
            const int a = i * (width + 1) + j;
            mesh.triangles.push_back({a, at(j), at(j + 1)});
            mesh.triangles.push_back({a, at(j + 1), a + 1});
        }
    }
    return mesh;
}

inline TriangleMesh together(TriangleMesh first, const TriangleMesh &second)
{
    const int shift = first.vertexCount();
    first.vertices.insert(first.vertices.end(), second.vertices.begin(), second.vertices.end());
    for (const Triangle &t : second.triangles)
        first.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
    return first;
}

/// Every triangle with vertices of its own, as an STL file holds it.
inline TriangleMesh exploded(const TriangleMesh &mesh)
{
    TriangleMesh soup;
    for (const Triangle &t : mesh.triangles) {
        const int first = soup.vertexCount();
        for (int v : t)
            soup.vertices.push_back(Vec3(mesh.vertices[v]));
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    return soup;
}

inline TriangleMesh turnedOver(TriangleMesh mesh)
{
    for (Triangle &t : mesh.triangles)
        std::swap(t[1], t[2]);
    return mesh;
}

/// Two outwards tetrahedra with one common vertex (number 0).
inline TriangleMesh tetrahedraSharingVertex()
{
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 4, 5}, {0, 6, 4}, {4, 6, 5}, {0, 5, 6}};
    return mesh;
}

/// Two outwards tetrahedra with the common edge 0-1.
inline TriangleMesh tetrahedraSharingEdge()
{
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {0, 0, 1}, {1, 0.2, 0}, {1, -0.2, 1}, {-1, 0.2, 0}, {-1, -0.2, 1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 1, 4}, {0, 5, 1}, {0, 4, 5}, {1, 5, 4}};
    for (int first : {0, 4}) { // by construction up to a mirror image; the volume decides
        TriangleMesh part{mesh.vertices,
                          {mesh.triangles.begin() + first, mesh.triangles.begin() + first + 4}};
        if (signedVolume(part) < 0.0)
            for (int t = first; t < first + 4; ++t)
                std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    }
    return mesh;
}

/// A flat sheet of 4 triangles with a fifth standing on its middle edge.
inline TriangleMesh sheetWithFin()
{
    TriangleMesh mesh = grid(2);
    mesh.vertices.push_back({0.5, 0.25, 0.8});
    mesh.triangles.push_back({1, 4, mesh.vertexCount() - 1});
    return mesh;
}

/// Two unit squares crossing at right angles along a common line of edges (true vertices).
inline TriangleMesh crossedSheets()
{
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {0, 1, 0},  {-1, 0, 0}, {-1, 1, 0}, {1, 0, 0},
                     {1, 1, 0}, {0, 0, -1}, {0, 1, -1}, {0, 0, 1},  {0, 1, 1}};
    mesh.triangles = {{2, 0, 1}, {2, 1, 3}, {0, 4, 5}, {0, 5, 1}, {6, 0, 1}, {6, 1, 7}, {0, 8, 9}, {0, 9, 1}};
    return mesh;
}

} // namespace ductus::zoo
