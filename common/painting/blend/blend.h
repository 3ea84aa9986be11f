// What a blend mode means for one colour. W3C Compositing and Blending Level 1, sections 5 and 10; the CPU
// oracle and the reference of the shaders. Colours are RGB 0..1 in the blend space; alpha is 0..1.
#pragma once

#include "painting/blend/blend_mode.h"

#include <Eigen/Core>

namespace ductus {

/// B(b, s): the mixture where backdrop \a b and source \a s both cover, straight colours.
Eigen::Vector3d blendFunction(BlendMode mode, const Eigen::Vector3d &b, const Eigen::Vector3d &s);

/// A layer's own colour where strokes have been composited: premultiplied by alpha.
struct PremultipliedColour
{
    Eigen::Vector3d colour = Eigen::Vector3d::Zero(); // each <= alpha
    double alpha = 0;
};

/// Source over: \a source on what is there (section 9.1.4).
PremultipliedColour over(const PremultipliedColour &source, const PremultipliedColour &below);

/// A layer on an opaque backdrop in the same space: (1 - a) b + a B(b, s), a = source.alpha * opacity
/// (section 10). \a opacity is the layer's times its masks'; it scales colour and alpha alike.
Eigen::Vector3d blendOnOpaque(BlendMode mode, const Eigen::Vector3d &backdrop, PremultipliedColour source,
                              double opacity);

/// sRGB encoding of linear light, IEC 61966-2-1, and back; channels 0..1.
Eigen::Vector3d encodedFromLinear(const Eigen::Vector3d &linear);
Eigen::Vector3d linearFromEncoded(const Eigen::Vector3d &encoded);

/// A linear straight colour in the numbers the painting blends in, and back.
Eigen::Vector3d toBlendSpace(BlendSpace space, const Eigen::Vector3d &linear);
Eigen::Vector3d fromBlendSpace(BlendSpace space, const Eigen::Vector3d &colour);

} // namespace ductus
