#include "geometry/inspection/wall_thickness.h"

#include "base/parallel.h"
#include "geometry/inspection/ray_tree.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

namespace ductus {

namespace {

constexpr double besideStart = 1e-7; // of the diagonal: a ray does not meet what it starts from
constexpr int mostParts = 64;        // of a triangle's side

struct Place
{
    Vec3 point;
    Vec3 normal;
    double area = 0.0;
};

// Centres of equal small triangles, as many of each triangle as its area asks for.
std::vector<Place> placesOn(const TriangleMesh &mesh, double area, int samples)
{
    std::vector<Place> places;
    const double areaEach = area / std::max(samples, 1);
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const Vec3 twice = mesh.areaVector(t);
        const double own = 0.5 * twice.norm();
        if (!(own > 0.0))
            continue;
        const Vec3 normal = twice.normalized();
        const Triangle &corners = mesh.triangles[std::size_t(t)];
        const Vec3 &a = mesh.vertices[std::size_t(corners[0])];
        const int parts = std::clamp(int(std::ceil(std::sqrt(own / areaEach) - 1e-9)), 1, mostParts);
        const Vec3 u = (mesh.vertices[std::size_t(corners[1])] - a) / parts,
                   v = (mesh.vertices[std::size_t(corners[2])] - a) / parts;
        for (int i = 0; i < parts; ++i)
            for (int k = 0; k < parts - i; ++k) {
                places.push_back({a + (i + 1.0 / 3) * u + (k + 1.0 / 3) * v, normal, own / (parts * parts)});
                if (k + 1 < parts - i)
                    places.push_back(
                        {a + (i + 2.0 / 3) * u + (k + 2.0 / 3) * v, normal, own / (parts * parts)});
            }
    }
    return places;
}

class Probe
{
public:
    Probe(const TriangleMesh &mesh, const ThicknessOptions &options)
        : mMesh(mesh), mTree(mesh), mBeside(besideStart * boundingBox(mesh.vertices).diagonal()),
          mLeastCosine(std::cos(options.largestTiltDegrees * M_PI / 180.0))
    {
    }

    // \a inwards: through the solid, which the ray must leave; else through the air, to enter one.
    std::optional<ThicknessSample> measure(const Place &place, bool inwards) const
    {
        const Vec3 direction = inwards ? Vec3(-place.normal) : place.normal;
        const std::optional<RayHit> hit = mTree.firstHit(place.point, direction, mBeside);
        if (!hit)
            return std::nullopt;
        const double leaves = mMesh.faceNormal(hit->triangle).dot(direction);
        if ((inwards ? leaves : -leaves) < mLeastCosine)
            return std::nullopt;
        return ThicknessSample{place.point, hit->point, hit->distance, place.area};
    }

private:
    const TriangleMesh &mMesh;
    RayTree mTree;
    double mBeside, mLeastCosine;
};

std::vector<ThicknessSample> sorted(const std::vector<std::optional<ThicknessSample>> &measured)
{
    std::vector<ThicknessSample> samples;
    for (const std::optional<ThicknessSample> &sample : measured)
        if (sample)
            samples.push_back(*sample);
    std::stable_sort(samples.begin(), samples.end(),
                     [](const ThicknessSample &a, const ThicknessSample &b) { return a.length < b.length; });
    return samples;
}

} // namespace

double Thickness::shareThinnerThan(double length) const
{
    double thin = 0.0;
    for (const ThicknessSample &sample : walls) {
        if (sample.length >= length)
            break;
        thin += sample.area;
    }
    return area > 0.0 ? thin / area : 0.0;
}

Result<Thickness> thicknessOf(const TriangleMesh &mesh, const ThicknessOptions &options,
                              const JobControl &control)
{
    Thickness thickness;
    thickness.area = surfaceArea(mesh);
    const std::vector<Place> places = placesOn(mesh, thickness.area, options.samples);
    const Probe probe(mesh, options);
    std::vector<std::optional<ThicknessSample>> walls(places.size()), gaps(places.size());
    parallelChunks(places.size(), 512, [&](std::size_t begin, std::size_t end) {
        if (control.isCancelled())
            return;
        for (std::size_t i = begin; i < end; ++i) {
            walls[i] = probe.measure(places[i], true);
            gaps[i] = probe.measure(places[i], false);
        }
    });
    if (control.isCancelled())
        return cancelledError("Measuring walls");
    thickness.walls = sorted(walls);
    thickness.gaps = sorted(gaps);
    return thickness;
}

} // namespace ductus
