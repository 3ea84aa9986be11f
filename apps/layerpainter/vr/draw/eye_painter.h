// EyePainter: draws a frame for both eyes and submits it.
#pragma once

#include "layerpainter/vr/draw/overlay_shapes.h"
#include "layerpainter/vr/session/headset_session.h"
#include "painting/scene/painting.h"

#include <memory>

namespace ductus {

class EyePainter
{
public:
    /// In the session's context, which must be current for everything here, the destructor too.
    static Result<std::unique_ptr<EyePainter>> create(const HeadsetRuntime &runtime,
                                                      const HeadsetSession &session);
    ~EyePainter();

    /// Draws \a painting as it stands at \a roomFromScene, with the overlay, and ends the frame with it.
    Result<void> draw(HeadsetSession &session, XrTime display, const std::vector<EyeView> &eyes,
                      std::shared_ptr<const Painting> painting, double seconds,
                      const Placement &roomFromScene, const OverlayShapes &overlay);

    /// A copy of what the left eye saw last, for the window: a texture, and its size.
    std::uint32_t mirror() const;
    int mirrorWidth() const;
    int mirrorHeight() const;

private:
    struct Parts; // their headers and Qt's of OpenGL do not go together
    explicit EyePainter(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> mParts;
};

} // namespace ductus
