// A canvas seen by a camera: the homography between the sheet and the picture, both ways.
#pragma once

#include "doodling/scene/shot_camera.h"
#include "doodling/tracking/track_canvas.h"
#include "imaging/image.h"

#include <optional>

namespace ductus {

/// \a camera with pixels \a factor times as wide: from the working copy's to the clip's.
ShotCamera scaledCamera(const ShotCamera &camera, double factor);

class CanvasView
{
public:
    CanvasView(const ShotCamera &camera, const CanvasFrame &place);

    /// The pixel a point of the sheet is seen at (canvas units). None for points behind the camera.
    std::optional<Vec2> pixelOf(const Vec2 &onCanvas) const;
    /// The point of the sheet seen at \a pixel. None where the ray misses the sheet's plane or meets it
    /// behind the camera.
    std::optional<Vec2> canvasPointOf(const Vec2 &pixel) const;
    /// Along the camera's axis, of a point of the sheet; scene units, negative behind the camera.
    double depthOf(const Vec2 &onCanvas) const;
    Vec3 worldPointOf(const Vec2 &onCanvas) const;

    /// From canvas units to homogeneous pixels; the third component is the depth.
    const Eigen::Matrix3d &pixelFromCanvas() const { return mPixelFromCanvas; }
    /// Its inverse; zero for sheets seen from the edge.
    const Eigen::Matrix3d &canvasFromPixel() const { return mCanvasFromPixel; }

    /// 1: the sheet faces the camera, 0: it is seen from its edge and vanishes. The cosine between the
    /// sheet's normal and the ray to its middle. Little of it makes drawing in the rectified view hard
    /// (thesis VI.6.3).
    double facing() const { return mFacing; }
    /// Whether the camera sees the sheet's back: drawings are mirrored.
    bool isFromBehind() const { return mIsFromBehind; }
    /// Pixels a canvas unit is long at the middle, the longest way.
    double pixelsAUnit() const;

private:
    CanvasFrame mPlace;
    Eigen::Matrix3d mPixelFromCanvas;
    Eigen::Matrix3d mCanvasFromPixel;
    double mFacing = 0.0;
    bool mIsFromBehind = false;
    bool mIsFlat = false; // seen from the edge: nothing can be mapped back
};

/// What of the \a picture a sheet of \a size (canvas units) covers, seen straight from above: \a width by
/// \a height pixels (thesis VI.4, the drawing panel's underlay). \a view in the picture's pixels. Clear where
/// the sheet reaches beyond the picture or behind the camera. Small when seen from afar, so averaged; big
/// when near, so between pixels.
Image rectified(const Image &picture, const CanvasView &view, const Vec2 &size, int width, int height);

} // namespace ductus
