// What a layer holds: painted strokes, and meshes wherever a stroke may stand. painting.md section 1.
#pragma once

#include "geometry/triangle_mesh.h"
#include "painting/scene/ids.h"
#include "painting/scene/placement.h"
#include "project/links/document_link.h"

#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace ductus {

/// Cross sections as in Quill (quill-and-tilt.md section 2). A ribbon has no inside.
enum class StrokeSection { Round, Ellipse, Cube, Ribbon };

struct PaintedPoint
{
    Eigen::Vector3f position = Eigen::Vector3f::Zero();
    Eigen::Vector3f normal = Eigen::Vector3f::UnitY(); // orients the section
    float halfWidth = 0;                               // >= 0, in the element's unit
    Eigen::Vector3f colour = Eigen::Vector3f::Zero();  // linear RGB, 0..1
    float opacity = 1;                                 // 0..1
};

/// A painted stroke; it stays one for ever, nothing bakes it into a mesh.
struct StrokeShape
{
    StrokeSection section = StrokeSection::Round;
    std::vector<PaintedPoint> points; // at least one
};

/// A surface from SketchSurfacer or a file.
struct MeshShape
{
    TriangleMesh mesh;
    std::vector<Eigen::Vector3f> vertexColours; // linear RGB, one a vertex
    std::optional<DocumentLink> link = {};      // the sketch it is the surface of; copies share it
};

using ElementShape = std::variant<StrokeShape, MeshShape>;

struct Element
{
    ElementId id;
    Placement placement;                       // layer from element
    std::shared_ptr<const ElementShape> shape; // never null; shared between copies
};

} // namespace ductus
