#include "layerpainter/vr/mode/room_marks.h"

#include "painting/blend/blend.h"
#include "painting/scene/element_placement.h"

#include <algorithm>
#include <unordered_set>

namespace ductus {

namespace {

const OverlayShapes::Colour handColour(0.62f, 0.64f, 0.70f, 1), rayColour(1, 1, 1, 0.75f),
    chosenColour(1.f, 0.72f, 0.2f, 0.95f), layerColour(0.3f, 0.8f, 1.f, 0.8f);
constexpr double lineWidth = 0.0025;       // metres
constexpr std::size_t mostPoints = 40'000; // of marks: of a layer of a city some must do

} // namespace

void addHands(OverlayShapes &shapes, const HandsInput &input, const HandTools &tools,
              const Eigen::Vector3f &brushColour, const std::optional<PanelHit> &pointed)
{
    for (const Hand hand : {Hand::Left, Hand::Right}) {
        const HandInput &is = input.of(hand);
        if (!is.isTracked)
            continue;
        const Vec3 back = is.grip.position + 0.06 * (is.grip.orientation * Vec3::UnitZ());
        shapes.addLine(back, is.grip.position, 0.026, handColour);
        shapes.addLine(is.grip.position, is.aim.position, 0.014, handColour);
        if (hand != tools.paintingHand()) {
            shapes.addBall(is.aim.position, 0.008, handColour);
            continue;
        }
        OverlayShapes::Colour tip = OverlayShapes::Colour::Ones();
        if (tools.mode() == HandMode::Paint)
            tip.head<3>() = encodedFromLinear(brushColour.cast<double>()).cast<float>();
        else
            tip = chosenColour;
        const double radius =
            tools.mode() == HandMode::Paint ? std::clamp(tools.brushRadius(), 0.002, 0.2) : 0.008;
        tip.w() = 0.85f;
        if (pointed) {
            shapes.addLine(is.aim.position, pointed->point, 0.002, rayColour);
            shapes.addBall(pointed->point, 0.005, rayColour);
        } else if (!tools.isPainting()) {
            shapes.addBall(is.aim.position, radius, tip);
        }
    }
}

void StrokeMarks::update(std::shared_ptr<const Painting> painting, double seconds,
                         const std::vector<ElementId> &selection, std::optional<LayerId> layer)
{
    if (painting == mPainting && seconds == mSeconds && selection == mSelection && layer == mLayer)
        return;
    mPainting = std::move(painting);
    mSeconds = seconds;
    mSelection = selection;
    mLayer = layer;
    mLines.clear();
    if (mSelection.empty() && !mLayer)
        return;
    const std::unordered_set<ElementId> chosen(mSelection.begin(), mSelection.end());
    const ElementPlacements placements(*mPainting, mSeconds);
    std::size_t points = 0;
    for (const Layer *of : mPainting->layers()) {
        for (const Element &element : of->drawingAt(placements.timeSeconds()).elements) {
            const bool isChosen = chosen.contains(element.id);
            const auto *stroke = std::get_if<StrokeShape>(element.shape.get());
            if (!stroke || (!isChosen && of->id != mLayer) || points > mostPoints)
                continue;
            const Eigen::Affine3d place = placements.sceneFromElement(*of, element).matrix();
            Line line{{}, isChosen};
            for (const PaintedPoint &point : stroke->points)
                line.points.push_back(place * point.position.cast<double>());
            points += line.points.size();
            mLines.push_back(std::move(line));
        }
    }
}

void StrokeMarks::add(OverlayShapes &shapes, const Placement &roomFromScene) const
{
    const Eigen::Affine3d place = roomFromScene.matrix();
    for (const Line &line : mLines) {
        const OverlayShapes::Colour &colour = line.isChosen ? chosenColour : layerColour;
        if (line.points.size() == 1)
            shapes.addBall(place * line.points.front(), 2 * lineWidth, colour);
        for (std::size_t i = 1; i < line.points.size(); ++i)
            shapes.addLine(place * line.points[i - 1], place * line.points[i], lineWidth, colour);
    }
}

} // namespace ductus
