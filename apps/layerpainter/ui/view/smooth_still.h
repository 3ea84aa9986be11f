// SmoothStill: the canvas without jagged edges while nothing moves. Frames whose camera is shifted by parts
// of a pixel are averaged, a few at a time, so that the first is shown at once and a hand never waits for the
// others; works alike with and without a graphics card, and costs a movement nothing.
#pragma once

#include "painting/reference/frame_camera.h"
#include "painting/scene/painting.h"

#include <QOpenGLFramebufferObject>
#include <QOpenGLTextureBlitter>
#include <memory>
#include <optional>

namespace ductus {

/// What a frame shows: while this is the same, frames may be averaged.
struct StillScene
{
    std::shared_ptr<const Painting> painting;
    double seconds = 0;
    FrameCamera camera;
    QSize size; // pixels

    bool operator==(const StillScene &other) const;
};

/// All functions but those that are const want the context current that was when it was made, the destructor
/// too.
class SmoothStill
{
public:
    static constexpr int samples = 9;

    SmoothStill() = default;
    ~SmoothStill();

    /// Begins with the frame of \a scene that lies in \a framebuffer.
    void begin(const StillScene &scene, unsigned framebuffer);
    void forget() { mScene.reset(); }

    bool isOf(const StillScene &scene) const { return mScene && *mScene == scene; }
    bool isDone() const { return mTaken >= samples; }
    /// Whether frames with shifted cameras were drawn since begin().
    bool hasShifted() const { return mScene && mTaken > 1; }

    /// The camera of the next frame, and where to draw it.
    FrameCamera nextCamera() const;
    unsigned nextFramebuffer() const { return mNext->handle(); }
    /// It was drawn there.
    void add();
    /// The mean of all so far.
    void show(unsigned framebuffer) const;

private:
    std::optional<StillScene> mScene;
    int mTaken = 0;
    std::unique_ptr<QOpenGLFramebufferObject> mNext, mMean;
    QOpenGLTextureBlitter mBlitter;
};

} // namespace ductus
