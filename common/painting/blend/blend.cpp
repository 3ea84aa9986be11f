#include "painting/blend/blend.h"

#include "base/assert.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

double multiply(double b, double s)
{
    return b * s;
}

double screen(double b, double s)
{
    return b + s - b * s;
}

double hardLight(double b, double s)
{
    return s <= 0.5 ? multiply(b, 2 * s) : screen(b, 2 * s - 1);
}

double colourDodge(double b, double s)
{
    if (b <= 0)
        return 0;
    return s >= 1 ? 1 : std::min(1.0, b / (1 - s));
}

double colourBurn(double b, double s)
{
    if (b >= 1)
        return 1;
    return s <= 0 ? 0 : 1 - std::min(1.0, (1 - b) / s);
}

double softLight(double b, double s)
{
    if (s <= 0.5)
        return b - (1 - 2 * s) * b * (1 - b);
    const double d = b <= 0.25 ? ((16 * b - 12) * b + 4) * b : std::sqrt(b);
    return b + (2 * s - 1) * (d - b);
}

/// The modes that treat each channel for itself (section 10.1).
double separable(BlendMode mode, double b, double s)
{
    switch (mode) {
    case BlendMode::Normal:
        return s;
    case BlendMode::Multiply:
        return multiply(b, s);
    case BlendMode::Screen:
        return screen(b, s);
    case BlendMode::Overlay:
        return hardLight(s, b);
    case BlendMode::Add:
        return std::min(1.0, b + s);
    case BlendMode::Darken:
        return std::min(b, s);
    case BlendMode::Lighten:
        return std::max(b, s);
    case BlendMode::ColourDodge:
        return colourDodge(b, s);
    case BlendMode::ColourBurn:
        return colourBurn(b, s);
    case BlendMode::HardLight:
        return hardLight(b, s);
    case BlendMode::SoftLight:
        return softLight(b, s);
    case BlendMode::Difference:
        return std::abs(b - s);
    case BlendMode::Exclusion:
        return b + s - 2 * b * s;
    default:
        break;
    }
    DUCTUS_ASSERT(false); // the others are not separable
}

// Section 10.2; the names are the W3C's.

double lum(const Eigen::Vector3d &c)
{
    return 0.3 * c[0] + 0.59 * c[1] + 0.11 * c[2];
}

double sat(const Eigen::Vector3d &c)
{
    return c.maxCoeff() - c.minCoeff();
}

Eigen::Vector3d clipColour(Eigen::Vector3d c)
{
    const double l = std::clamp(lum(c), 0.0, 1.0); // white must not become more than white
    const double n = c.minCoeff();
    const double x = c.maxCoeff();
    const Eigen::Vector3d grey = Eigen::Vector3d::Constant(l);
    if (n < 0)
        c = grey + (c - grey) * (l / (l - n));
    if (x > 1)
        c = grey + (c - grey) * ((1 - l) / (x - l));
    return c.cwiseMax(0).cwiseMin(1); // rounding
}

Eigen::Vector3d setLum(const Eigen::Vector3d &c, double l)
{
    return clipColour(c + Eigen::Vector3d::Constant(l - lum(c)));
}

Eigen::Vector3d setSat(const Eigen::Vector3d &c, double s)
{
    const double range = sat(c);
    if (range <= 0)
        return Eigen::Vector3d::Zero();
    return (c - Eigen::Vector3d::Constant(c.minCoeff())) * (s / range);
}

double encoded(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double decoded(double value)
{
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

} // namespace

Eigen::Vector3d blendFunction(BlendMode mode, const Eigen::Vector3d &b, const Eigen::Vector3d &s)
{
    switch (mode) {
    case BlendMode::Hue:
        return setLum(setSat(s, sat(b)), lum(b));
    case BlendMode::Saturation:
        return setLum(setSat(b, sat(s)), lum(b));
    case BlendMode::Colour:
        return setLum(s, lum(b));
    case BlendMode::Luminosity:
        return setLum(b, lum(s));
    default:
        return {separable(mode, b[0], s[0]), separable(mode, b[1], s[1]), separable(mode, b[2], s[2])};
    }
}

PremultipliedColour over(const PremultipliedColour &source, const PremultipliedColour &below)
{
    return {source.colour + (1 - source.alpha) * below.colour,
            source.alpha + (1 - source.alpha) * below.alpha};
}

Eigen::Vector3d blendOnOpaque(BlendMode mode, const Eigen::Vector3d &backdrop, PremultipliedColour source,
                              double opacity)
{
    if (source.alpha <= 0)
        return backdrop;
    const Eigen::Vector3d straight = (source.colour / source.alpha).cwiseMax(0).cwiseMin(1);
    const double a = source.alpha * opacity;
    return (1 - a) * backdrop + a * blendFunction(mode, backdrop, straight);
}

Eigen::Vector3d encodedFromLinear(const Eigen::Vector3d &linear)
{
    return linear.unaryExpr(&encoded);
}

Eigen::Vector3d linearFromEncoded(const Eigen::Vector3d &value)
{
    return value.unaryExpr(&decoded);
}

Eigen::Vector3d toBlendSpace(BlendSpace space, const Eigen::Vector3d &linear)
{
    return space == BlendSpace::Encoded ? encodedFromLinear(linear) : linear;
}

Eigen::Vector3d fromBlendSpace(BlendSpace space, const Eigen::Vector3d &colour)
{
    return space == BlendSpace::Encoded ? linearFromEncoded(colour) : colour;
}

} // namespace ductus
