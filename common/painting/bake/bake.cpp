#include "painting/bake/bake.h"

#include "base/parallel.h"
#include "painting/bake/stroke_mesh.h"

#include <atomic>
#include <cmath>
#include <map>

namespace ductus {

namespace {

constexpr const char *attempted = "Baking the painting";

Error tooLarge()
{
    return {ErrorCode::TooLarge, attempted, "the painting would have too many vertices",
            "Choose a longer edge, or hide stacks", ""};
}

/// A stack while it grows: each vertex remembers its element and its own colour.
struct Growing
{
    BakedStack baked;
    std::vector<SubstratePoint> points;
};

/// Cuts the longest edges of triangles in half until none is longer than \a edge; both sides of an edge cut
/// it at the same vertex, and whether it is cut depends on its length alone, so that no cracks open.
bool divide(TriangleMesh &mesh, std::vector<Eigen::Vector3f> &colours, double edge, std::int64_t maxVertices)
{
    for (bool changed = true; changed;) {
        changed = false;
        std::map<std::pair<int, int>, int> middles;
        const auto middle = [&](int a, int b) {
            const auto key = std::minmax(a, b);
            const auto [found, isNew] = middles.try_emplace(key, mesh.vertexCount());
            if (isNew) {
                mesh.vertices.push_back(0.5 *
                                        (mesh.vertices[std::size_t(a)] + mesh.vertices[std::size_t(b)]));
                colours.push_back(0.5f * (colours[std::size_t(a)] + colours[std::size_t(b)]));
            }
            return found->second;
        };
        std::vector<Triangle> triangles;
        for (const Triangle &t : mesh.triangles) {
            std::array<int, 3> cut{-1, -1, -1};
            int cuts = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                const int a = t[i], b = t[(i + 1) % 3];
                if ((mesh.vertices[std::size_t(a)] - mesh.vertices[std::size_t(b)]).norm() > edge) {
                    cut[i] = middle(a, b);
                    ++cuts;
                }
            }
            changed = changed || cuts > 0;
            if (cuts == 0) {
                triangles.push_back(t);
            } else if (cuts == 3) {
                triangles.insert(triangles.end(), {{t[0], cut[0], cut[2]},
                                                   {cut[0], t[1], cut[1]},
                                                   {cut[2], cut[1], t[2]},
                                                   {cut[0], cut[1], cut[2]}});
            } else {
                std::size_t i = 0; // an edge that is cut, after one that is not
                while (cut[i] < 0 || cut[(i + 2) % 3] >= 0)
                    ++i;
                const int a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3], m = cut[i], n = cut[(i + 1) % 3];
                triangles.push_back({a, m, c});
                if (n < 0) {
                    triangles.push_back({m, b, c});
                } else {
                    triangles.push_back({m, b, n});
                    triangles.push_back({m, n, c});
                }
            }
        }
        mesh.triangles = std::move(triangles);
        if (mesh.vertexCount() > maxVertices)
            return false;
    }
    return true;
}

class Baking
{
public:
    Baking(const PaintingSolid &solid, const BakeOptions &options, const JobControl &control)
        : mSolid(solid), mOptions(options), mControl(control)
    {
    }

    Result<std::vector<BakedStack>> run()
    {
        std::vector<BakedStack> baked;
        const std::size_t count = mSolid.stackCount();
        for (std::size_t i = 0; i < count; ++i) {
            if (!mSolid.substrate(i))
                continue;
            mControl.progress(double(i) / double(count), attempted);
            Growing growing;
            if (const Result<void> built = build(i, growing); !built)
                return built.error();
            if (growing.baked.mesh.isEmpty())
                continue;
            colour(growing);
            if (mControl.isCancelled())
                return cancelledError(attempted);
            baked.push_back(std::move(growing.baked));
        }
        return baked;
    }

private:
    Result<void> build(std::size_t stack, Growing &growing)
    {
        const LayerSolid &substrate = *mSolid.substrate(stack);
        const Stack &source = mSolid.painting().stacks[stack];
        growing.baked.stack = source.id;
        growing.baked.name = source.name;
        SubstratePoint point;
        point.stack = int(stack);
        point.stackId = source.id;
        const std::vector<SegmentData> &segments = substrate.segments();
        for (std::size_t begin = 0, end = 0; begin < segments.size(); begin = end) {
            while (end < segments.size() && segments[end].element == segments[begin].element)
                ++end;
            if (mControl.isCancelled())
                return cancelledError(attempted);
            const std::span<const SegmentData> stroke(segments.data() + begin, end - begin);
            const SkinMesh skin = strokeMesh(stroke, mOptions.edgeLength);
            point.element = substrate.element(int(segments[begin].element)).id;
            const int first = growing.baked.mesh.vertexCount();
            for (const SkinVertex &vertex : skin.vertices) {
                const SegmentData &segment = stroke[vertex.segment];
                const float t = float(segmentParameter(segment, vertex.position));
                point.position = vertex.position;
                point.colour = (1 - t) * segment.colourA + t * segment.colourB;
                point.opacity = double((1 - t) * segment.opacityA + t * segment.opacityB);
                addVertex(growing, point, substrate);
            }
            for (const Triangle &t : skin.triangles)
                growing.baked.mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
            if (mVertices > mOptions.maxVertices)
                return tooLarge();
        }
        return buildMeshes(substrate, point, growing);
    }

    Result<void> buildMeshes(const LayerSolid &substrate, SubstratePoint point, Growing &growing)
    {
        for (const LayerSolid::MeshElement &element : substrate.meshes()) {
            TriangleMesh mesh = element.solid.mesh();
            std::vector<Eigen::Vector3f> colours = element.solid.vertexColours();
            if (!divide(mesh, colours, mOptions.edgeLength, mOptions.maxVertices - mVertices))
                return tooLarge();
            if (mControl.isCancelled())
                return cancelledError(attempted);
            point.element = substrate.element(element.element).id;
            point.opacity = 1;
            const int first = growing.baked.mesh.vertexCount();
            for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
                point.position = mesh.vertices[i];
                point.colour = substrate.properties().colour ? *substrate.properties().colour : colours[i];
                addVertex(growing, point, substrate);
            }
            for (const Triangle &t : mesh.triangles)
                growing.baked.mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
        }
        return {};
    }

    void addVertex(Growing &growing, SubstratePoint point, const LayerSolid &substrate)
    {
        point.opacity *= substrate.properties().opacity;
        growing.baked.mesh.vertices.push_back(point.position);
        growing.points.push_back(point);
        ++mVertices;
    }

    void colour(Growing &growing) const
    {
        growing.baked.colours.resize(growing.points.size());
        parallelChunks(growing.points.size(), 512, [&](std::size_t begin, std::size_t end) {
            if (mControl.isCancelled())
                return;
            for (std::size_t i = begin; i < end; ++i) {
                const SubstratePoint &point = growing.points[i];
                const Eigen::Vector3d linear =
                    fromBlendSpace(mSolid.painting().blendSpace, mSolid.colour(point, nullptr));
                growing.baked.colours[i] << linear.cast<float>(), float(point.opacity);
            }
        });
    }

    const PaintingSolid &mSolid;
    const BakeOptions &mOptions;
    const JobControl &mControl;
    std::int64_t mVertices = 0;
};

} // namespace

Result<std::vector<BakedStack>> bakePainting(const Painting &painting, const BakeOptions &options,
                                             const JobControl &control)
{
    if (!(options.edgeLength > 0) || !std::isfinite(options.edgeLength))
        return Error{ErrorCode::InvalidArgument, attempted, "the edge has no length",
                     "Give a length above 0 in scene units", ""};
    const Result<PaintingSolid> solid = PaintingSolid::make(painting, options.moment, control);
    if (!solid) {
        Error error = solid.error();
        error.attempted = attempted;
        return error;
    }
    return Baking(*solid, options, control).run();
}

} // namespace ductus
