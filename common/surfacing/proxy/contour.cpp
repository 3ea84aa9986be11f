#include "surfacing/proxy/contour.h"

#include "base/parallel.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <unordered_set>

namespace ductus {

namespace {

constexpr const char *attempted = "Contouring the smooth surface";

// Grid nodes as one number; 20 bits a coordinate.
using NodeKey = std::uint64_t;

NodeKey keyOf(int x, int y, int z)
{
    return (NodeKey(x) << 40) | (NodeKey(y) << 20) | NodeKey(z);
}

std::array<int, 3> cellOf(NodeKey key)
{
    constexpr NodeKey mask = (1u << 20) - 1;
    return {int(key >> 40), int((key >> 20) & mask), int(key & mask)};
}

// Corner c of a cube stands at offsets (c & 1, c >> 1 & 1, c >> 2 & 1). The six tetrahedra around the diagonal 0-7
// (Kuhn's subdivision) agree between neighbouring cubes; each is positively oriented.
constexpr int tetrahedra[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};

class Contour
{
public:
    Contour(const ScalarField &field, const Box3 &box, const ContourOptions &options)
        : mField(field), mOptions(options), mOrigin(box.min)
    {
        for (int k = 0; k < 3; ++k)
            mCells[k] = std::max(1, int(std::ceil((box.max[k] - box.min[k]) / options.cellSize)));
    }

    bool tooFine() const { return *std::max_element(mCells.begin(), mCells.end()) >= (1 << 20) - 2; }

    Result<void> follow(const std::vector<Vec3> &seeds, const JobControl &control)
    {
        std::vector<NodeKey> front;
        std::unordered_set<NodeKey> visited;
        const auto visit = [&](int x, int y, int z) {
            if (x < 0 || y < 0 || z < 0 || x >= mCells[0] || y >= mCells[1] || z >= mCells[2])
                return;
            if (visited.insert(keyOf(x, y, z)).second)
                front.push_back(keyOf(x, y, z));
        };
        for (const Vec3 &seed : seeds) {
            const Vec3 at = (seed - mOrigin) / mOptions.cellSize;
            for (int dx = -1; dx <= 1; ++dx)
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dz = -1; dz <= 1; ++dz)
                        visit(int(std::floor(at.x())) + dx, int(std::floor(at.y())) + dy,
                              int(std::floor(at.z())) + dz);
        }
        while (!front.empty()) {
            if (control.isCancelled())
                return cancelledError(attempted);
            if (int(visited.size()) > mOptions.maxCells)
                return Error{ErrorCode::TooLarge, attempted, "the smooth surface does not end near the strokes",
                             "Give a proxy mesh", ""};
            std::vector<NodeKey> cells;
            cells.swap(front);
            evaluate(cells);
            for (NodeKey cell : cells) {
                if (!isCut(cell))
                    continue;
                mCutCells.push_back(cell);
                const auto [x, y, z] = cellOf(cell);
                visit(x - 1, y, z);
                visit(x + 1, y, z);
                visit(x, y - 1, z);
                visit(x, y + 1, z);
                visit(x, y, z - 1);
                visit(x, y, z + 1);
            }
        }
        std::sort(mCutCells.begin(), mCutCells.end());
        return {};
    }

    TriangleMesh extract()
    {
        for (NodeKey cell : mCutCells)
            for (const auto &tetrahedron : tetrahedra)
                cutTetrahedron(cell, tetrahedron);
        placeVertices();
        return std::move(mMesh);
    }

private:
    NodeKey cornerOf(NodeKey cell, int corner) const
    {
        const auto [x, y, z] = cellOf(cell);
        return keyOf(x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2 & 1));
    }

    Vec3 position(NodeKey node) const
    {
        const auto [x, y, z] = cellOf(node);
        return mOrigin + mOptions.cellSize * Vec3(x, y, z);
    }

    void evaluate(const std::vector<NodeKey> &cells)
    {
        std::vector<NodeKey> fresh;
        for (NodeKey cell : cells)
            for (int c = 0; c < 8; ++c)
                if (mValues.emplace(cornerOf(cell, c), 0.0).second)
                    fresh.push_back(cornerOf(cell, c));
        std::vector<double> values(fresh.size());
        parallelFor(0, fresh.size(), [&](std::size_t i) { values[i] = mField(position(fresh[i])); }, 64);
        for (std::size_t i = 0; i < fresh.size(); ++i)
            mValues[fresh[i]] = values[i];
    }

    bool isCut(NodeKey cell) const
    {
        int negative = 0;
        for (int c = 0; c < 8; ++c)
            negative += mValues.at(cornerOf(cell, c)) < 0.0;
        return negative != 0 && negative != 8;
    }

    int vertexOn(NodeKey a, NodeKey b)
    {
        if (a > b)
            std::swap(a, b);
        const auto [it, isNew] = mVertexOfEdge.emplace(std::make_pair(a, b), int(mEdges.size()));
        if (isNew)
            mEdges.push_back({a, b});
        return it->second;
    }

    void cutTetrahedron(NodeKey cell, const int (&corners)[4])
    {
        std::array<NodeKey, 4> nodes;
        std::vector<int> inside, outside;
        for (int k = 0; k < 4; ++k) {
            nodes[std::size_t(k)] = cornerOf(cell, corners[k]);
            (mValues.at(nodes[std::size_t(k)]) < 0.0 ? inside : outside).push_back(k);
        }
        const auto v = [&](int i, int o) { return vertexOn(nodes[std::size_t(i)], nodes[std::size_t(o)]); };
        // The sign of the permutation (inside..., outside...) says which way round the triangle faces outwards.
        if (inside.empty() || outside.empty())
            return;
        std::array<int, 4> order{};
        std::copy(inside.begin(), inside.end(), order.begin());
        std::copy(outside.begin(), outside.end(), order.begin() + std::ptrdiff_t(inside.size()));
        bool even = true;
        for (int i = 0; i < 4; ++i)
            for (int j = i + 1; j < 4; ++j)
                even ^= order[std::size_t(i)] > order[std::size_t(j)];
        if (inside.size() == 1)
            add(v(order[0], order[1]), v(order[0], order[2]), v(order[0], order[3]), even);
        else if (inside.size() == 3)
            add(v(order[0], order[3]), v(order[1], order[3]), v(order[2], order[3]), even);
        else {
            const int a = v(order[0], order[2]), b = v(order[0], order[3]);
            const int c = v(order[1], order[3]), d = v(order[1], order[2]);
            add(a, b, c, even);
            add(a, c, d, even);
        }
    }

    void add(int a, int b, int c, bool keepOrder)
    {
        if (keepOrder)
            mMesh.triangles.push_back({a, b, c});
        else
            mMesh.triangles.push_back({a, c, b});
    }

    void placeVertices()
    {
        mMesh.vertices.resize(mEdges.size());
        parallelFor(0, mEdges.size(), [&](std::size_t i) {
            Vec3 p = position(mEdges[i].first), q = position(mEdges[i].second);
            double fp = mValues.at(mEdges[i].first), fq = mValues.at(mEdges[i].second);
            Vec3 root = p + fp / (fp - fq) * (q - p);
            for (int step = 0; step < mOptions.edgeRefinements; ++step) {
                const double fr = mField(root);
                if ((fr < 0.0) == (fp < 0.0)) {
                    p = root;
                    fp = fr;
                } else {
                    q = root;
                    fq = fr;
                }
                if (fp == fq)
                    break;
                root = p + fp / (fp - fq) * (q - p);
            }
            mMesh.vertices[i] = root;
        }, 64);
    }

    struct PairHash
    {
        std::size_t operator()(const std::pair<NodeKey, NodeKey> &pair) const
        {
            return std::hash<NodeKey>()(pair.first * 0x9e3779b97f4a7c15ull ^ pair.second);
        }
    };

    const ScalarField &mField;
    const ContourOptions &mOptions;
    Vec3 mOrigin;
    std::array<int, 3> mCells{};
    std::unordered_map<NodeKey, double> mValues;
    std::vector<NodeKey> mCutCells;
    std::unordered_map<std::pair<NodeKey, NodeKey>, int, PairHash> mVertexOfEdge;
    std::vector<std::pair<NodeKey, NodeKey>> mEdges;
    TriangleMesh mMesh;
};

} // namespace

Result<TriangleMesh> contourFromSeeds(const ScalarField &field, const std::vector<Vec3> &seeds, const Box3 &box,
                                      const ContourOptions &options, const JobControl &control)
{
    Contour contour(field, box, options);
    if (contour.tooFine())
        return Error{ErrorCode::TooLarge, attempted, "the grid would be too fine", "", ""};
    if (Result<void> followed = contour.follow(seeds, control); !followed)
        return followed.error();
    return contour.extract();
}

} // namespace ductus
