#include "layerpainter/document/stroke_exchange.h"

#include "painting/scene/element_placement.h"

#include <algorithm>
#include <unordered_set>

namespace ductus {

namespace {

CopiedStroke copied(const StrokeShape &shape, const Placement &place,
                    const std::optional<Eigen::Vector3f> &all)
{
    CopiedStroke stroke;
    const Eigen::Affine3d matrix = place.matrix();
    double opacity = 0;
    float widest = 0;
    for (const PaintedPoint &point : shape.points) {
        stroke.line.points.push_back(matrix * point.position.cast<double>());
        stroke.halfWidths.push_back(place.scale * double(point.halfWidth));
        opacity += double(point.opacity) / double(shape.points.size());
        widest = std::max(widest, point.halfWidth);
    }
    if (widest > 0)
        for (const PaintedPoint &point : shape.points)
            stroke.line.pressure.push_back(double(point.halfWidth / widest));
    stroke.colour = all ? *all : shape.points.front().colour;
    stroke.opacity = std::clamp(opacity, 0.0, 1.0);
    return stroke;
}

} // namespace

CopiedStrokes copiedElements(const Painting &painting, const std::vector<ElementId> &elements)
{
    CopiedStrokes strokes;
    strokes.metresPerUnit = painting.metresPerUnit;
    const std::unordered_set<ElementId> chosen(elements.begin(), elements.end());
    const ElementPlacements placements(painting, 0);
    for (const Layer *layer : painting.layers())
        for (const Drawing &drawing : layer->drawings)
            for (const Element &element : drawing.elements)
                if (const auto *shape = std::get_if<StrokeShape>(element.shape.get());
                    shape && chosen.contains(element.id))
                    strokes.strokes.push_back(copied(*shape, placements.sceneFromElement(*layer, element),
                                                     layer->properties.colour));
    return strokes;
}

std::vector<ElementId> elementsOf(const Painting &painting, LayerId layer)
{
    std::vector<ElementId> elements;
    if (const Layer *found = painting.findLayer(layer))
        for (const Element &element : found->drawings.front().elements)
            elements.push_back(element.id);
    return elements;
}

act::Draw drawnStrokes(const CopiedStrokes &strokes, const Painting &painting, LayerId layer,
                       double halfWidth, const Eigen::Vector3f &colour)
{
    act::Draw draw;
    draw.layer = layer;
    for (const CopiedStroke &stroke : inUnit(strokes, painting.metresPerUnit, UpAxis::Y).strokes) {
        StrokeShape shape;
        for (std::size_t i = 0; i < stroke.line.points.size(); ++i) {
            PaintedPoint point;
            point.position = stroke.line.points[i].cast<float>();
            const double pressure = stroke.line.pressure.empty() ? 1.0 : stroke.line.pressure[i];
            point.halfWidth = float(stroke.halfWidths.empty() ? halfWidth * pressure : stroke.halfWidths[i]);
            point.colour = stroke.colour.value_or(colour);
            point.opacity = float(stroke.opacity);
            shape.points.push_back(point);
        }
        draw.strokes.push_back(std::make_shared<const ElementShape>(std::move(shape)));
    }
    return draw;
}

Project sketchProject(const CopiedStrokes &strokes, const std::string &name)
{
    SketchSurfaceDocument document;
    document.strokes.metresPerUnit = strokes.metresPerUnit;
    document.strokes.upAxis = strokes.upAxis;
    for (const CopiedStroke &stroke : strokes.strokes) {
        Stroke line = stroke.line;
        line.id = StrokeId{std::int32_t(document.strokes.strokes.size())};
        document.strokes.strokes.push_back(std::move(line));
    }
    Project project;
    project.generator = "LayerPainter";
    project.id = Uuid::create();
    project.documents.push_back(newSketchSurface(Uuid::create(), name, std::move(document)));
    return project;
}

} // namespace ductus
