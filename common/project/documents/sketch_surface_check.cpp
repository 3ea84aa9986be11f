// checkSketchSurface(): the rules of sketch_surface_reader.cpp, asked of a document before it is written.
#include "project/documents/sketch_surface_json.h"

#include "project/documents/sketch_surface_names.h"

#include <cmath>
#include <set>

namespace ductus {

namespace {

class Checker
{
public:
    explicit Checker(std::string place) : mPlace(std::move(place)) {}

    void require(bool condition, const std::string &field, const char *problem)
    {
        if (!condition && !mError)
            mError =
                Error{ErrorCode::InvalidArgument, "Writing the project", problem, "", mPlace + "#/" + field};
    }

    void requireFinite(const std::vector<Vec3> &points, const std::string &field)
    {
        for (const Vec3 &point : points)
            require(point.allFinite(), field, "a coordinate is not a finite number");
    }

    void requireFinite(const std::vector<double> &values, const std::string &field)
    {
        for (double value : values)
            require(std::isfinite(value), field, "a value is not a finite number");
    }

    void requireMesh(const TriangleMesh &mesh, const std::string &field)
    {
        requireFinite(mesh.vertices, field + "/vertices");
        for (const Triangle &triangle : mesh.triangles) {
            for (int v : triangle)
                require(v >= 0 && v < mesh.vertexCount(), field + "/triangles",
                        "a triangle has no such vertex");
        }
    }

    Result<void> result() const { return mError ? Result<void>(*mError) : Result<void>(); }

private:
    std::string mPlace;
    std::optional<Error> mError;
};

void checkStrokes(const StrokeSet &set, Checker &checker)
{
    checker.require(std::isfinite(set.metresPerUnit) && set.metresPerUnit > 0.0, "metresPerUnit",
                    "the unit must be longer than zero metres");
    checker.require(set.strokes.size() <= maxStoredStrokes, "strokes", "there are too many");
    std::set<StrokeId> ids;
    for (std::size_t i = 0; i < set.strokes.size(); ++i) {
        const Stroke &stroke = set.strokes[i];
        const std::string field = "strokes/" + std::to_string(i);
        checker.require(stroke.id.isValid(), field + "/id", "the stroke has no id");
        checker.require(ids.insert(stroke.id).second, field + "/id", "two strokes have the same id");
        checker.requireFinite(stroke.points, field + "/points");
        checker.requireFinite(stroke.pressure, field + "/pressure");
        checker.requireFinite(stroke.timeSeconds, field + "/timeSeconds");
        checker.require(stroke.pressure.empty() || stroke.pressure.size() == stroke.points.size(),
                        field + "/pressure", "there must be one value a point");
        checker.require(stroke.timeSeconds.empty() || stroke.timeSeconds.size() == stroke.points.size(),
                        field + "/timeSeconds", "there must be one value a point");
    }
}

void checkSettings(const SurfacingSettings &settings, Checker &checker)
{
    checker.requireFinite({settings.epsilon, settings.simplicity, settings.smoothness}, "settings");
    checker.require(settings.epsilon > 0.0, "settings/epsilon", "it must be greater than zero");
    checker.require(settings.simplicity >= 0.0, "settings/simplicity", "it must not be negative");
    checker.require(settings.smoothness >= 0.0, "settings/smoothness", "it must not be negative");
    checker.require(settings.runs >= 1 && settings.runs <= 1000, "settings/runs",
                    "there must be 1 to 1000 runs");
    if (settings.symmetryPlane) {
        checker.requireFinite({settings.symmetryPlane->point, settings.symmetryPlane->normal},
                              "settings/symmetryPlane");
        checker.require(!settings.symmetryPlane->normal.isZero(0.0), "settings/symmetryPlane/normal",
                        "it has no length");
    }
}

void checkSurface(const StoredSurface &surface, Checker &checker)
{
    checker.requireMesh(surface.mesh, "surface/mesh");
    checker.require(surface.triangleRegions.empty() ||
                        surface.triangleRegions.size() == surface.mesh.triangles.size(),
                    "surface/triangleRegions", "there must be one region a triangle");
    for (int region : surface.triangleRegions)
        checker.require(region >= 0 && region < maxRegion, "surface/triangleRegions",
                        "a region number is out of range");
    for (const std::vector<int> &line : surface.featureLines) {
        for (int v : line)
            checker.require(v >= 0 && v < surface.mesh.vertexCount(), "surface/featureLines",
                            "there is no such vertex");
    }
    checker.require(surface.models.size() <= maxStoredModels, "surface/models", "there are too many");
    for (std::size_t i = 0; i < surface.models.size(); ++i) {
        const std::string field = "surface/models/" + std::to_string(i);
        checker.require(surface.models[i].degree >= 0 && surface.models[i].degree <= 16, field + "/degree",
                        "the degree must be 0 to 16");
        checker.requireFinite(surface.models[i].coefficients, field + "/coefficients");
    }
}

void checkReading(const StoredReading &reading, Checker &checker)
{
    checker.requireFinite(reading.points, "reading/points");
    checker.require(reading.labels.size() == reading.points.size(), "reading/labels",
                    "there must be one label a point");
    checker.require(reading.models.size() <= maxStoredModels, "reading/models", "there are too many");
    for (int label : reading.labels)
        checker.require(label >= 0 && std::size_t(label) < reading.models.size(), "reading/labels",
                        "there is no such model");
    for (std::size_t i = 0; i < reading.models.size(); ++i) {
        const StoredReadingModel &model = reading.models[i];
        const std::string field = "reading/models/" + std::to_string(i);
        checker.require(model.degree >= 1 && model.degree <= maxReadingDegree, field + "/degree",
                        "the degree must be 1 to 4");
        checker.require(model.coefficients.size() == readingCoefficients(model.degree),
                        field + "/coefficients", "there must be one for each monomial");
        checker.requireFinite(model.coefficients, field + "/coefficients");
        checker.requireFinite(std::vector<Vec3>{model.origin}, field + "/origin");
    }
}

} // namespace

Result<void> checkSketchSurface(const SketchSurfaceDocument &document, const std::string &place)
{
    Checker checker(place);
    checkStrokes(document.strokes, checker);
    checkSettings(document.settings, checker);
    if (document.proxy)
        checker.requireMesh(document.proxy->mesh, "proxy/mesh");
    if (document.surface)
        checkSurface(*document.surface, checker);
    if (document.reading)
        checkReading(*document.reading, checker);
    return checker.result();
}

} // namespace ductus
