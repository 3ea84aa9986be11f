// Marks in the room: hands, the brush's tip, the ray, what is chosen and whose layer's row is pointed at.
#pragma once

#include "layerpainter/vr/draw/overlay_shapes.h"
#include "layerpainter/vr/mode/hand_tools.h"
#include "layerpainter/vr/panels/panel_rig.h"

namespace ductus {

void addHands(OverlayShapes &shapes, const HandsInput &input, const HandTools &tools,
              const Eigen::Vector3f &brushColour, const std::optional<PanelHit> &pointed);

/// Thin lines along strokes; they belong to the painting and lie where it stands.
class StrokeMarks
{
public:
    /// Looks for the strokes anew only if the painting, the choice or the layer is another.
    void update(std::shared_ptr<const Painting> painting, double seconds,
                const std::vector<ElementId> &selection, std::optional<LayerId> layer);
    void add(OverlayShapes &shapes, const Placement &roomFromScene) const;

private:
    struct Line
    {
        std::vector<Vec3> points; // scene
        bool isChosen = true;     // else of the layer
    };
    std::shared_ptr<const Painting> mPainting;
    double mSeconds = 0;
    std::vector<ElementId> mSelection;
    std::optional<LayerId> mLayer;
    std::vector<Line> mLines;
};

} // namespace ductus
