// Small projects with every field set, for tests here and in tests/format. Values that only survive an exact
// round trip.
#pragma once

#include "base/random.h"
#include "project/project.h"

#include <cmath>
#include <limits>

namespace ductus {

/// A document with all roles, strokes with and without channels, a proxy, a surface. \a seed varies every
/// coordinate.
inline SketchSurfaceDocument sampleSketchSurface(std::uint64_t seed, int strokeCount = 6,
                                                 int pointsPerStroke = 9)
{
    Random random(seed);
    const auto randomPoint = [&] {
        return Vec3(random.normal(), random.normal() / 3.0, random.normal() * 1e-3);
    };
    SketchSurfaceDocument document;
    document.strokes.metresPerUnit = 0.1;
    document.strokes.upAxis = UpAxis::Z;
    for (int i = 0; i < strokeCount; ++i) {
        Stroke stroke;
        stroke.id = StrokeId{3 * i + 1};
        stroke.role = StrokeRole(i % 5);
        for (int k = 0; k < pointsPerStroke; ++k) {
            stroke.points.push_back(randomPoint());
            if (i % 2 == 0)
                stroke.pressure.push_back(random.uniform());
            if (i % 3 == 0)
                stroke.timeSeconds.push_back(0.1 * k + random.uniform() / 30.0);
        }
        document.strokes.strokes.push_back(std::move(stroke));
    }
    document.strokes.strokes.front().points[0] = {-0.0, std::numeric_limits<double>::denorm_min(), 1e300};
    document.settings.epsilon = 0.1 + 0.2; // not 0.3
    document.settings.simplicity = 1.0 / 3.0;
    document.settings.smoothness = 10.0;
    document.settings.runs = 7;
    document.settings.seed = std::numeric_limits<std::uint64_t>::max() - seed;
    document.settings.symmetryPlane = StoredSymmetryPlane{randomPoint(), {1.0, 0.1, -0.0}, {}};
    TriangleMesh mesh;
    for (int i = 0; i < 5; ++i)
        mesh.vertices.push_back(randomPoint());
    mesh.triangles = {{0, 1, 2}, {2, 1, 3}, {4, 0, 3}};
    document.proxy = StoredProxy{mesh, {}};
    mesh.vertices.push_back(randomPoint());
    mesh.triangles.push_back({5, 4, 3});
    StoredSurface surface;
    surface.mesh = mesh;
    surface.triangleRegions = {0, 2, 2, 1};
    surface.featureLines = {{0, 1, 3}, {}, {5, 4}};
    surface.models = {{1, {0.1, -0.2, 0.3, random.normal()}, {}},
                      {2, std::vector<double>(10, random.normal()), {}}};
    document.surface = std::move(surface);
    document.reading = StoredReading{{randomPoint(), randomPoint(), randomPoint()},
                                     {1, 0, 1},
                                     {{1, randomPoint(), {0.5, -0.0, random.normal(), 1.0}, {}},
                                      {2, randomPoint(), std::vector<double>(10, random.normal()), {}}},
                                     {}};
    return document;
}

/// Two documents, a thumbnail and a preview (bytes that are not a real PNG). The same seed gives the same
/// project.
inline Project sampleProject(std::uint64_t seed)
{
    Random random(seed);
    Project project;
    project.id = Uuid::from(random);
    project.generator = "Ductus tests";
    project.documents.push_back(newSketchSurface(Uuid::from(random),
                                                 "Chapeau \xe5\xb8\xbd\xe5\xad\x90", // hat, Chinese
                                                 sampleSketchSurface(seed)));
    project.documents.push_back(
        newSketchSurface(Uuid::from(random), "Second", sampleSketchSurface(seed + 1000, 2, 3)));
    project.thumbnail = storedEntry("thumbnail.png", asBytes("thumbnail"));
    project.documents[1].preview = storedEntry("preview", asBytes("preview"));
    return project;
}

/// Empty if the two are the same to the bit, otherwise the first field that differs. Unknown members are
/// compared too.
inline std::string difference(const SketchSurfaceDocument &a, const SketchSurfaceDocument &b)
{
    const auto samePoints = [](const std::vector<Vec3> &p, const std::vector<Vec3> &q) {
        return p.size() == q.size() &&
               (p.empty() || std::memcmp(p.data(), q.data(), p.size() * sizeof(Vec3)) == 0);
    };
    const auto sameNumbers = [](const std::vector<double> &p, const std::vector<double> &q) {
        return p.size() == q.size() &&
               (p.empty() || std::memcmp(p.data(), q.data(), p.size() * sizeof(double)) == 0);
    };
    const auto sameMesh = [&](const TriangleMesh &p, const TriangleMesh &q) {
        return samePoints(p.vertices, q.vertices) && p.triangles == q.triangles;
    };
    if (a.strokes.metresPerUnit != b.strokes.metresPerUnit || a.strokes.upAxis != b.strokes.upAxis)
        return "unit or axis";
    if (a.strokes.strokes.size() != b.strokes.strokes.size())
        return "stroke count";
    for (std::size_t i = 0; i < a.strokes.strokes.size(); ++i) {
        const Stroke &s = a.strokes.strokes[i];
        const Stroke &t = b.strokes.strokes[i];
        if (s.id != t.id || s.role != t.role || !samePoints(s.points, t.points) ||
            !sameNumbers(s.pressure, t.pressure) || !sameNumbers(s.timeSeconds, t.timeSeconds))
            return "stroke " + std::to_string(i);
    }
    const SurfacingSettings &x = a.settings;
    const SurfacingSettings &y = b.settings;
    if (x.epsilon != y.epsilon || x.simplicity != y.simplicity || x.smoothness != y.smoothness ||
        x.runs != y.runs || x.seed != y.seed || x.symmetryPlane.has_value() != y.symmetryPlane.has_value() ||
        x.unknown != y.unknown)
        return "settings";
    if (x.symmetryPlane && (!samePoints({x.symmetryPlane->point, x.symmetryPlane->normal},
                                        {y.symmetryPlane->point, y.symmetryPlane->normal}) ||
                            x.symmetryPlane->unknown != y.symmetryPlane->unknown))
        return "symmetry plane";
    if (a.proxy.has_value() != b.proxy.has_value() ||
        (a.proxy && (!sameMesh(a.proxy->mesh, b.proxy->mesh) || a.proxy->unknown != b.proxy->unknown)))
        return "proxy";
    if (a.surface.has_value() != b.surface.has_value())
        return "surface";
    if (a.surface) {
        if (!sameMesh(a.surface->mesh, b.surface->mesh) || a.surface->unknown != b.surface->unknown)
            return "surface mesh";
        if (a.surface->triangleRegions != b.surface->triangleRegions ||
            a.surface->featureLines != b.surface->featureLines)
            return "regions or feature lines";
        if (a.surface->models.size() != b.surface->models.size())
            return "model count";
        for (std::size_t i = 0; i < a.surface->models.size(); ++i) {
            const StoredModel &m = a.surface->models[i];
            const StoredModel &n = b.surface->models[i];
            if (m.degree != n.degree || !sameNumbers(m.coefficients, n.coefficients) ||
                m.unknown != n.unknown)
                return "model " + std::to_string(i);
        }
    }
    if (a.reading.has_value() != b.reading.has_value())
        return "reading";
    if (a.reading) {
        if (!samePoints(a.reading->points, b.reading->points) || a.reading->labels != b.reading->labels ||
            a.reading->unknown != b.reading->unknown || a.reading->models.size() != b.reading->models.size())
            return "reading";
        for (std::size_t i = 0; i < a.reading->models.size(); ++i) {
            const StoredReadingModel &m = a.reading->models[i];
            const StoredReadingModel &n = b.reading->models[i];
            if (m.degree != n.degree || !samePoints({m.origin}, {n.origin}) ||
                !sameNumbers(m.coefficients, n.coefficients) || m.unknown != n.unknown)
                return "reading model " + std::to_string(i);
        }
    }
    return a.strokeUnknown == b.strokeUnknown && a.unknown == b.unknown ? "" : "unknown members";
}

/// The same for whole projects (content, not what saving needs).
inline std::string difference(const Project &a, const Project &b)
{
    if (a.id != b.id || a.generator != b.generator || a.documents.size() != b.documents.size() ||
        a.unknown != b.unknown)
        return "project.json";
    for (std::size_t i = 0; i < a.documents.size(); ++i) {
        const ProjectDocument &d = a.documents[i];
        const ProjectDocument &e = b.documents[i];
        const std::string place = "document " + std::to_string(i) + ": ";
        if (d.id != e.id || d.kind != e.kind || d.name != e.name || d.unknown != e.unknown)
            return place + "record";
        if (d.preview.has_value() != e.preview.has_value() ||
            (d.preview && *d.preview->packed != *e.preview->packed))
            return place + "preview";
        if ((d.sketchSurface == nullptr) != (e.sketchSurface == nullptr))
            return place + "content";
        if (d.sketchSurface) {
            if (std::string what = difference(*d.sketchSurface, *e.sketchSurface); !what.empty())
                return place + what;
        }
    }
    if (a.thumbnail.has_value() != b.thumbnail.has_value() ||
        (a.thumbnail && *a.thumbnail->packed != *b.thumbnail->packed))
        return "thumbnail";
    return {};
}

} // namespace ductus
