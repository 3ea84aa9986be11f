#include "surfacing/parts/tube.h"

#include "surfacing/parts/centre_line.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ductus {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int capRings = 3; // of a hemisphere, besides its pole

Vec3 anyNormalTo(const Vec3 &tangent)
{
    int axis = 0;
    tangent.cwiseAbs().minCoeff(&axis);
    return tangent.cross(Vec3::Unit(axis)).normalized();
}

// The frame carried on by two reflections [Wang et al. 2008, algorithm 1].
Vec3 carried(const Vec3 &normal, const Vec3 &fromPoint, const Vec3 &fromTangent, const Vec3 &toPoint,
             const Vec3 &toTangent)
{
    const Vec3 v1 = toPoint - fromPoint;
    const double c1 = v1.squaredNorm();
    const Vec3 reflected = normal - (2.0 / c1) * v1.dot(normal) * v1;
    const Vec3 tangent = fromTangent - (2.0 / c1) * v1.dot(fromTangent) * v1;
    const Vec3 v2 = toTangent - tangent;
    const double c2 = v2.squaredNorm();
    const Vec3 result = c2 > 1e-30 ? Vec3(reflected - (2.0 / c2) * v2.dot(reflected) * v2) : reflected;
    return (result - result.dot(toTangent) * toTangent).normalized(); // errors do not add up
}

std::vector<Vec3> normalsOf(const CentreLine &line)
{
    std::vector<Vec3> normals{anyNormalTo(line.tangents.front())};
    const std::size_t n = line.points.size();
    for (std::size_t i = 1; i < n; ++i)
        normals.push_back(carried(normals.back(), line.points[i - 1], line.tangents[i - 1], line.points[i],
                                  line.tangents[i]));
    if (!line.isLoop)
        return normals;
    // What the frame has turned by when it is back: spread evenly over the loop.
    const Vec3 back = carried(normals.back(), line.points.back(), line.tangents.back(), line.points.front(),
                              line.tangents.front());
    const Vec3 side = line.tangents.front().cross(normals.front());
    const double turned = std::atan2(back.dot(side), back.dot(normals.front()));
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = -turned * double(i) / double(n);
        normals[i] = Eigen::AngleAxisd(angle, line.tangents[i]) * normals[i];
    }
    return normals;
}

class TubeBuilder
{
public:
    TubeBuilder(TriangleMesh &mesh, int sides) : mMesh(mesh), mSides(sides) {}

    void pole(const Vec3 &place)
    {
        mMesh.vertices.push_back(place);
        const int pole = mMesh.vertexCount() - 1;
        for (int k = 0; mLastRing >= 0 && k < mSides; ++k)
            mMesh.triangles.push_back({mLastRing + k, mLastRing + (k + 1) % mSides, pole});
        mFirstPole = mLastRing < 0 ? pole : -1;
    }

    void ring(const Vec3 &centre, double radius, const Vec3 &normal, const Vec3 &tangent)
    {
        const Vec3 side = tangent.cross(normal);
        const int ring = mMesh.vertexCount();
        for (int k = 0; k < mSides; ++k) {
            const double angle = 2.0 * pi * k / mSides;
            mMesh.vertices.push_back(centre + radius * (std::cos(angle) * normal + std::sin(angle) * side));
        }
        if (mLastRing >= 0)
            join(mLastRing, ring);
        for (int k = 0; mFirstPole >= 0 && k < mSides; ++k)
            mMesh.triangles.push_back({mFirstPole, ring + (k + 1) % mSides, ring + k});
        mFirstPole = -1;
        mFirstRing = mFirstRing < 0 ? ring : mFirstRing;
        mLastRing = ring;
    }

    void closeLoop() { join(mLastRing, mFirstRing); }

private:
    void join(int a, int b)
    {
        for (int k = 0; k < mSides; ++k) {
            const int next = (k + 1) % mSides;
            mMesh.triangles.push_back({a + k, a + next, b + k});
            mMesh.triangles.push_back({a + next, b + next, b + k});
        }
    }

    TriangleMesh &mMesh;
    int mSides;
    int mFirstPole = -1;
    int mFirstRing = -1;
    int mLastRing = -1;
};

void addTube(const CentreLine &line, bool isFlatAtStart, bool isFlatAtEnd, int sides, TriangleMesh &mesh)
{
    const std::vector<Vec3> normals = normalsOf(line);
    TubeBuilder builder(mesh, sides);
    const auto cap = [&](std::size_t i, bool isStart, bool isFlat) {
        const Vec3 &centre = line.points[i], &tangent = line.tangents[i];
        const double radius = line.radii[i], way = isStart ? -1.0 : 1.0;
        if (isFlat) {
            builder.pole(centre);
            return;
        }
        if (isStart)
            builder.pole(centre - radius * tangent);
        for (int c = 1; c < capRings; ++c) {
            const double angle = 0.5 * pi * (isStart ? capRings - c : c) / capRings;
            builder.ring(centre + way * radius * std::sin(angle) * tangent, radius * std::cos(angle),
                         normals[i], tangent);
        }
        if (!isStart)
            builder.pole(centre + radius * tangent);
    };
    const std::size_t n = line.points.size();
    if (!line.isLoop)
        cap(0, true, isFlatAtStart);
    for (std::size_t i = 0; i < n; ++i)
        builder.ring(line.points[i], line.radii[i], normals[i], line.tangents[i]);
    if (line.isLoop)
        builder.closeLoop();
    else
        cap(n - 1, false, isFlatAtEnd);
}

} // namespace

Result<TriangleMesh> sweptTube(const std::vector<Vec3> &points, const std::vector<double> &radii,
                               const TubeOptions &options)
{
    constexpr char attempted[] = "Making a tube along a stroke";
    bool isSound = points.size() == radii.size() && options.sides >= 3;
    for (const Vec3 &p : points)
        isSound &= p.allFinite();
    for (double r : radii)
        isSound &= std::isfinite(r) && r > 0.0;
    if (!isSound)
        return Error{ErrorCode::InvalidArgument, attempted,
                     "its places and radii are not all finite, or a radius is not positive",
                     "Give it a width", ""};
    const bool hasLength =
        std::any_of(points.begin(), points.end(), [&](const Vec3 &p) { return p != points.front(); });
    if (!hasLength)
        return Error{ErrorCode::TooLittleData, attempted, "it has no length",
                     "Draw it longer, or leave it out", ""};

    const std::vector<CentreLine> lines = centreLines(points, radii, options);
    TriangleMesh mesh;
    const bool isFlat = options.ends == TubeEnds::Flat;
    for (std::size_t i = 0; i < lines.size(); ++i) // joints between pieces are balls, whatever the ends are
        addTube(lines[i], isFlat && i == 0, isFlat && i + 1 == lines.size(), options.sides, mesh);
    return mesh;
}

} // namespace ductus
