#include "layerpainter/vr/panels/panel_rig.h"

#include <array>
#include <cmath>
#include <numbers>

namespace ductus {

namespace {

constexpr double metresPerPixel = 0.30 / 340; // a hand's width and a half
constexpr double above = 0.10;                // the hand, metres
constexpr double gap = 0.015;                 // between panels

Vec3 level(const Vec3 &v)
{
    const Vec3 flat(v.x(), 0, v.z());
    return flat.norm() > 1e-6 ? Vec3(flat.normalized()) : Vec3(0, 0, 1);
}

} // namespace

void PanelRig::add(std::unique_ptr<PanelSurface> panel)
{
    mPanels.emplace_back();
    mPanels.back().surface = std::move(panel);
}

void PanelRig::setShown(bool shown)
{
    mIsShown = shown;
    if (!shown)
        for (Panel &panel : mPanels)
            panel.surface->leave();
}

void PanelRig::turn(int steps)
{
    const int n = count();
    mFront = n > 0 ? ((mFront + steps) % n + n) % n : 0;
}

// The front panel stands upright above the hand and looks at the head; its neighbours stand at its sides,
// turned in like the wings of a mirror.
void PanelRig::follow(const RoomPose &hand, const RoomPose &head)
{
    mHead = head.position;
    mIsPlaced = true;
    const Vec3 flat = level(head.position - hand.position);
    const double width = 340 * metresPerPixel;
    for (int i = 0; i < count(); ++i) {
        Panel &panel = mPanels[std::size_t(i)];
        int slot = ((i - mFront) % count() + count()) % count();
        if (slot > count() / 2)
            slot -= count();
        const double angle = slot * 50 * std::numbers::pi / 180;
        const Eigen::AngleAxisd turn(-angle, Vec3::UnitY());
        const Vec3 right = Vec3::UnitY().cross(flat);
        panel.towards = turn * flat;
        panel.right = turn * right;
        panel.up = Vec3::UnitY();
        const double height = panel.surface->size().height() * metresPerPixel;
        // Wings begin where the front panel ends.
        const double half = 0.5 * width;
        Vec3 across = Vec3::Zero();
        for (int step = 0; step != slot; step += slot > 0 ? 1 : -1) {
            const double sign = slot > 0 ? 1 : -1;
            const Eigen::AngleAxisd next(-(step + sign) * 50 * std::numbers::pi / 180, Vec3::UnitY());
            const Eigen::AngleAxisd last(-step * 50 * std::numbers::pi / 180, Vec3::UnitY());
            across += sign * ((half + 0.5 * gap) * (last * right) + (half + 0.5 * gap) * (next * right));
        }
        panel.middle = hand.position + (above + 0.5 * height) * Vec3::UnitY() + across;
    }
}

bool PanelRig::isSeen(const Panel &panel) const
{
    return mIsShown && mIsPlaced && panel.towards.dot(mHead - panel.middle) > 0;
}

Vec3 PanelRig::pointOn(int index, const QPointF &at) const
{
    const Panel &panel = mPanels[std::size_t(index)];
    const QSizeF size = panel.surface->size();
    return panel.middle + metresPerPixel * ((at.x() - 0.5 * size.width()) * panel.right +
                                            (0.5 * size.height() - at.y()) * panel.up);
}

std::optional<PanelHit> PanelRig::place(int index, const Vec3 &point) const
{
    const Panel &panel = mPanels[std::size_t(index)];
    const QSizeF size = panel.surface->size();
    const Vec3 offset = point - panel.middle;
    const QPointF at(offset.dot(panel.right) / metresPerPixel + 0.5 * size.width(),
                     0.5 * size.height() - offset.dot(panel.up) / metresPerPixel);
    if (!QRectF(QPointF(), size).contains(at))
        return std::nullopt;
    return PanelHit{index, at, point, 0, offset.dot(panel.towards)};
}

std::optional<PanelHit> PanelRig::hit(const RoomPose &aim) const
{
    std::optional<PanelHit> nearest;
    for (int i = 0; i < count(); ++i) {
        const Panel &panel = mPanels[std::size_t(i)];
        const double against = aim.forward().dot(panel.towards);
        if (!isSeen(panel) || against > -1e-3)
            continue;
        const double distance = (panel.middle - aim.position).dot(panel.towards) / against;
        if (distance < 0 || (nearest && nearest->distance < distance))
            continue;
        if (auto found = place(i, aim.position + distance * aim.forward())) {
            found->distance = distance;
            found->height = 0;
            nearest = found;
        }
    }
    return nearest;
}

std::optional<PanelHit> PanelRig::touch(const Vec3 &tip, double reach) const
{
    std::optional<PanelHit> nearest;
    for (int i = 0; i < count(); ++i) {
        if (!isSeen(mPanels[std::size_t(i)]))
            continue;
        auto found = place(i, tip);
        if (found && std::abs(found->height) <= reach &&
            (!nearest || std::abs(found->height) < std::abs(nearest->height)))
            nearest = found;
    }
    return nearest;
}

void PanelRig::upload(Panel &panel)
{
    const QImage &image = panel.surface->image();
    if (panel.uploaded == panel.surface->imageNumber())
        return;
    panel.uploaded = panel.surface->imageNumber();
    panel.texture.upload(image.constBits(), image.width(), image.height());
}

void PanelRig::draw(OverlayShapes &shapes)
{
    for (int i = 0; i < count(); ++i) {
        Panel &panel = mPanels[std::size_t(i)];
        if (!isSeen(panel))
            continue;
        upload(panel);
        const QSizeF size = panel.surface->size();
        shapes.addPanel({pointOn(i, {0, size.height()}), pointOn(i, {size.width(), size.height()}),
                         pointOn(i, {size.width(), 0}), pointOn(i, {0, 0})},
                        panel.texture.name());
    }
}

void PanelRig::releaseTextures()
{
    for (Panel &panel : mPanels) {
        panel.texture = {};
        panel.uploaded = -1;
    }
}

} // namespace ductus
