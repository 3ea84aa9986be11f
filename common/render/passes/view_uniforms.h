// The camera as the shaders know it: view.glsl.
#pragma once

#include "painting/reference/frame_camera.h"
#include "render/gl/gl_object.h"

namespace ductus {

class ViewUniforms
{
public:
    /// Sends and binds them.
    void set(const FrameCamera &camera, int width, int height);

private:
    GlBuffer mBuffer;
};

} // namespace ductus
