// SketchSurfaceDocument: what SketchSurfacer stores of one sketch. Plain data without algorithms;
// common/surfacing converts to and from its own types. Doubles come back from a file bit for bit.
#pragma once

#include "project/json/raw_json.h"
#include "strokes/stroke.h"

#include <map>
#include <optional>
#include <vector>

namespace ductus {

struct StoredSymmetryPlane
{
    Vec3 point = Vec3::Zero();   // in the sketch's unit
    Vec3 normal = Vec3::UnitX(); // any length but zero
    UnknownMembers unknown;
};

/// Parameters of the surfacing, thesis Sec. III.5.2 (defaults: surfacing.md section 1).
struct SurfacingSettings
{
    double epsilon = 0.01;    // of the bounding-box diagonal
    double simplicity = 0.01; // weight of the label costs
    double smoothness = 10.0; // weight of the borders
    int runs = 10;            // seeded runs the best is taken of
    std::uint64_t seed = 1;
    std::optional<StoredSymmetryPlane> symmetryPlane;
    UnknownMembers unknown;
};

struct StoredProxy
{
    TriangleMesh mesh;
    UnknownMembers unknown;
};

/// One fitted model: a polynomial of the given degree, coefficients in the order of common/surfacing.
struct StoredModel
{
    int degree = 1; // 0..16
    std::vector<double> coefficients;
    UnknownMembers unknown;
};

struct StoredSurface
{
    TriangleMesh mesh;
    std::vector<int> triangleRegions;           // >= 0, one a triangle, or empty
    std::vector<std::vector<int>> featureLines; // polylines of vertex indices
    std::vector<StoredModel> models;            // by region number where the regions have models
    UnknownMembers unknown;
};

struct StoredReadingModel
{
    int degree = 1;                   // 1..4
    Vec3 origin = Vec3::Zero();       // the monomials are of the point less the origin
    std::vector<double> coefficients; // in order of degree: 1, x, y, z, xx, xy, ...
    UnknownMembers unknown;
};

/// What the user took the sketch for where the strokes allow more than one surface: regions, told by points
/// of the proxy. All in the sketch's unit.
struct StoredReading
{
    std::vector<Vec3> points;
    std::vector<int> labels; // index into models, one a point
    std::vector<StoredReadingModel> models;
    UnknownMembers unknown;
};

struct SketchSurfaceDocument
{
    StrokeSet strokes; // ids unique and valid
    SurfacingSettings settings;
    std::optional<StoredProxy> proxy;
    std::optional<StoredSurface> surface;
    std::optional<StoredReading> reading;             // none: the likeliest
    std::map<StrokeId, UnknownMembers> strokeUnknown; // further channels of strokes, by later versions
    UnknownMembers unknown;
};

inline constexpr char sketchSurfaceKind[] = "sketch-surface";
inline constexpr int sketchSurfaceVersion = 1;

} // namespace ductus
