// PanelRig: panels around the hand that does not paint, one of them in front; and what points at them.
#pragma once

#include "layerpainter/vr/draw/overlay_shapes.h"
#include "layerpainter/vr/hands/hand_input.h"
#include "layerpainter/vr/panels/panel_surface.h"
#include "layerpainter/vr/panels/panel_texture.h"

#include <memory>
#include <optional>
#include <vector>

namespace ductus {

struct PanelHit
{
    int panel = -1;
    QPointF at;          // logical pixels
    Vec3 point;          // in the room
    double distance = 0; // along the ray, metres
    double height = 0;   // of a finger above the panel, metres; < 0 behind it
};

class PanelRig
{
public:
    /// The first panel is in front.
    void add(std::unique_ptr<PanelSurface> panel);
    int count() const { return int(mPanels.size()); }
    PanelSurface &panel(int index) { return *mPanels[std::size_t(index)].surface; }

    void setShown(bool shown);
    bool isShown() const { return mIsShown; }
    /// The next panel comes to the front: 1 from the right, -1 from the left.
    void turn(int steps);
    int front() const { return mFront; }

    /// The hand that holds them, and the head they face. Until it was called there is nothing to see.
    void follow(const RoomPose &hand, const RoomPose &head);

    /// What a ray meets first; and what a tip is about to touch, not farther than \a reach before or behind.
    std::optional<PanelHit> hit(const RoomPose &aim) const;
    std::optional<PanelHit> touch(const Vec3 &tip, double reach) const;
    /// Where in the room a place of a panel is.
    Vec3 pointOn(int panel, const QPointF &at) const;

    /// Pictures that changed go to the card (of the context that is current), the panels to \a shapes.
    void draw(OverlayShapes &shapes);
    /// Gives back what is on the card.
    void releaseTextures();

private:
    struct Panel
    {
        std::unique_ptr<PanelSurface> surface;
        PanelTexture texture;
        int uploaded = -1;               // imageNumber() of what is on the card
        Vec3 middle, right, up, towards; // unit directions; towards: out of the picture
    };
    std::optional<PanelHit> place(int index, const Vec3 &point) const;
    void upload(Panel &panel);
    bool isSeen(const Panel &panel) const;

    std::vector<Panel> mPanels;
    int mFront = 0;
    bool mIsShown = true;
    bool mIsPlaced = false;
    Vec3 mHead = Vec3::Zero();
};

} // namespace ductus
