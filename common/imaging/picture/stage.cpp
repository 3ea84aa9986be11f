#include "imaging/picture/stage.h"

#include "imaging/picture/colour.h"
#include "imaging/picture/corner_normals.h"

#include <algorithm>
#include <cmath>

namespace ductus::picture {

namespace {

// Beyond this the squares of coordinates overflow.
constexpr double largestCoordinate = 1e100;

bool isDrawable(const Vec3 &p)
{
    return p.allFinite() && p.cwiseAbs().maxCoeff() < largestCoordinate;
}

// The triangles of \a mesh that can be drawn; \a kept receives their numbers.
TriangleMesh drawableMesh(const TriangleMesh &mesh, std::vector<int> &kept)
{
    TriangleMesh result;
    result.vertices = mesh.vertices;
    const auto isGoodCorner = [&](int v) {
        return v >= 0 && v < mesh.vertexCount() && isDrawable(mesh.vertices[std::size_t(v)]);
    };
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const Triangle &corners = mesh.triangles[std::size_t(t)];
        if (!std::all_of(corners.begin(), corners.end(), isGoodCorner))
            continue;
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
            continue;
        result.triangles.push_back(corners);
        kept.push_back(t);
    }
    for (Vec3 &v : result.vertices) {
        if (!isDrawable(v))
            v.setZero(); // no triangle uses it
    }
    return result;
}

// Maps the scene into the stage.
struct StageFrame
{
    Vec3 centre = Vec3::Zero();
    double scale = 1.0;
    bool zUp = false;

    Vec3 direction(const Vec3 &d) const { return zUp ? Vec3(d.x(), d.z(), -d.y()) : d; }
    Vec3 point(const Vec3 &p) const { return direction((p - centre) * scale); }
};

struct DrawableMesh
{
    TriangleMesh mesh;
    std::vector<int> kept; // number in the scene's mesh of each triangle
};

StageFrame frameOf(const std::vector<DrawableMesh> &meshes, const PictureScene &scene, bool zUp)
{
    Box3 box;
    for (const DrawableMesh &drawable : meshes) {
        for (const Triangle &triangle : drawable.mesh.triangles) {
            for (int corner : triangle)
                box.add(drawable.mesh.vertices[std::size_t(corner)]);
        }
    }
    for (const PictureLine &line : scene.lines) {
        for (const Vec3 &p : line.points) {
            if (isDrawable(p))
                box.add(p);
        }
    }
    for (const Vec3 &p : scene.alsoInFrame) {
        if (isDrawable(p))
            box.add(p);
    }
    if (box.isEmpty())
        return {Vec3::Zero(), 1.0, zUp};
    // A single point has no diagonal; then its tube says how large the scene is.
    double diagonal = box.diagonal();
    if (diagonal <= 0.0) {
        for (const PictureLine &line : scene.lines)
            diagonal = std::max(diagonal, 4.0 * line.radius);
    }
    return {box.centre(), diagonal > 0.0 ? 1.0 / diagonal : 1.0, zUp};
}

std::array<Vec3, 3> cornerAlbedo(const PictureMesh &source, const Triangle &corners, int triangle)
{
    if (!source.vertexColours.empty() && source.vertexColours.size() == source.mesh.vertices.size()) {
        std::array<Vec3, 3> albedo;
        for (std::size_t k = 0; k < 3; ++k)
            albedo[k] = linearFromRgba(source.vertexColours[std::size_t(corners[k])]);
        return albedo;
    }
    const bool own = std::size_t(triangle) < source.triangleColours.size();
    const Vec3 one = linearFromRgba(own ? source.triangleColours[std::size_t(triangle)] : source.colour);
    return {one, one, one};
}

void addMesh(const PictureMesh &source, const DrawableMesh &drawable, const StageFrame &frame, Stage &stage)
{
    const TriangleMesh &mesh = drawable.mesh;
    const CornerNormals normals = cornerNormals(mesh, source.smooth ? source.creaseAngleDegrees : 0.0);
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        if (normals.faces[std::size_t(t)].isZero())
            continue; // no area
        const Triangle &corners = mesh.triangles[std::size_t(t)];
        StageTriangle triangle;
        for (std::size_t k = 0; k < 3; ++k) {
            triangle.corners[k] = frame.point(mesh.vertices[std::size_t(corners[k])]);
            triangle.normals[k] = frame.direction(normals.corners[std::size_t(t)][k]);
        }
        triangle.albedo = cornerAlbedo(source, corners, drawable.kept[std::size_t(t)]);
        triangle.faceNormal = frame.direction(normals.faces[std::size_t(t)]);
        stage.triangles.push_back(triangle);
    }
}

void addCreases(const PictureMesh &source, const DrawableMesh &drawable, const StageFrame &frame,
                Stage &stage)
{
    const auto differ = [&](int t, int u) {
        const auto colourOf = [&](int i) {
            const auto original = std::size_t(drawable.kept[std::size_t(i)]);
            return original < source.triangleColours.size() ? source.triangleColours[original]
                                                            : source.colour;
        };
        return source.vertexColours.empty() && colourOf(t) != colourOf(u);
    };
    for (const auto &[v, w] : creaseEdges(drawable.mesh, source.creaseAngleDegrees, differ)) {
        StageTube tube;
        tube.a = frame.point(drawable.mesh.vertices[std::size_t(v)]);
        tube.b = frame.point(drawable.mesh.vertices[std::size_t(w)]);
        tube.albedo = Vec3(0.012, 0.012, 0.014);
        tube.isCrease = true;
        stage.tubes.push_back(tube);
    }
}

void addLine(const PictureLine &line, const StageFrame &frame, Stage &stage)
{
    StageTube tube;
    tube.radius = std::isfinite(line.radius) ? std::max(0.0, line.radius) * frame.scale : 0.0;
    tube.visibleBehind =
        std::isfinite(line.visibleBehind) ? std::max(0.0, line.visibleBehind) * frame.scale : 0.0;
    tube.albedo = linearFromRgba(line.colour);
    tube.faintWhenHidden = line.faintWhenHidden;
    const std::size_t count = line.points.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (!isDrawable(line.points[i]))
            continue;
        const bool hasNext = i + 1 < count && isDrawable(line.points[i + 1]);
        const bool hadPrevious = i > 0 && isDrawable(line.points[i - 1]);
        if (!hasNext && hadPrevious)
            continue; // drawn as the end of the piece before
        tube.a = frame.point(line.points[i]);
        tube.b = hasNext ? frame.point(line.points[i + 1]) : tube.a;
        stage.tubes.push_back(tube);
    }
}

} // namespace

Stage makeStage(const PictureScene &scene, bool zUp)
{
    std::vector<DrawableMesh> meshes(scene.meshes.size());
    for (std::size_t i = 0; i < meshes.size(); ++i)
        meshes[i].mesh = drawableMesh(scene.meshes[i].mesh, meshes[i].kept);
    const StageFrame frame = frameOf(meshes, scene, zUp);

    Stage stage;
    for (std::size_t i = 0; i < meshes.size(); ++i)
        addMesh(scene.meshes[i], meshes[i], frame, stage);
    for (const PictureLine &line : scene.lines)
        addLine(line, frame, stage);
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        if (scene.meshes[i].drawCreases)
            addCreases(scene.meshes[i], meshes[i], frame, stage);
    }

    for (const Vec3 &p : scene.alsoInFrame) {
        if (isDrawable(p))
            stage.alsoInFrame.push_back(frame.point(p));
    }

    double lowest = 1e300;
    for (const StageTriangle &triangle : stage.triangles) {
        for (const Vec3 &corner : triangle.corners)
            lowest = std::min(lowest, corner.y());
    }
    for (const StageTube &tube : stage.tubes)
        lowest = std::min(lowest, std::min(tube.a.y(), tube.b.y()) - tube.radius);
    stage.groundHeight = stage.isEmpty() ? 0.0 : lowest;
    return stage;
}

} // namespace ductus::picture
