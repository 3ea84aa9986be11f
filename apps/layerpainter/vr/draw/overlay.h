// OverlayRenderer: draws what is not the painting over it, and turns frames into linear light.
#pragma once

#include "layerpainter/vr/draw/overlay_shapes.h"
#include "painting/reference/frame_camera.h"
#include "render/gl/gl_object.h"
#include "render/gl/shader_program.h"
#include "render/painting_renderer.h"

#include <map>
#include <optional>
#include <vector>

namespace ductus {

class OverlayRenderer
{
public:
    OverlayRenderer();

    void upload(const OverlayShapes &shapes);
    /// Onto the framebuffer that is bound, its whole viewport. \a camera in the room. What lies behind the
    /// painting (\a surface; none: nothing does) shines through it weakly.
    void draw(const FrameCamera &camera, const std::optional<SeenSurface> &surface, double metresPerUnit);

    /// \a from (sRGB in an 8-bit texture) as linear light onto the framebuffer that is bound.
    void convert(std::uint32_t from);

private:
    GLuint program(int samples);

    std::map<int, GlProgram> mPrograms; // by samples of the surface, 0: none
    GlProgram mConvert;
    GlVertexArray mArray;
    GlBuffer mBuffer;
    std::vector<OverlayShapes::Part> mParts;
};

} // namespace ductus
