// A prop as a frame's camera sees it: colours with alpha, and how far away each pixel of it is.
#pragma once

#include "doodling/compositing/layer.h"
#include "doodling/prop/prop.h"
#include "doodling/tracking/track_canvas.h"
#include "painting/reference/painting_solid.h"

namespace ductus {

struct PropPicture
{
    PaintedLayer layer;        // opacity as painted; the canvas' is not in it
    std::vector<float> depths; // along the camera's axis, scene units of the shot; infinity where it is not

    /// At a pixel of the picture; \a otherwise where the prop is not.
    double depthAt(const Vec2 &pixel, double otherwise) const;
};

/// The part of the picture within \a limits the \a painting can be seen in.
PixelBox propBox(const PaintingSolid &painting, const Prop &prop, const CanvasFrame &place,
                 const ShotCamera &camera, const PixelBox &limits);

/// \a painting (the prop's, at the moment) drawn exactly, \a samplesPerAxis squared rays a pixel. \a camera
/// in pixels of the picture. Nothing where it is behind the camera.
PropPicture propPicture(const PaintingSolid &painting, const Prop &prop, const CanvasFrame &place,
                        const ShotCamera &camera, const PixelBox &limits, int samplesPerAxis);

} // namespace ductus
