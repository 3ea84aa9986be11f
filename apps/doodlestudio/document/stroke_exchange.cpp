#include "doodlestudio/document/stroke_exchange.h"

#include "doodling/canvas/edit_doodle.h"
#include "painting/blend/blend.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double filledShare = 0.8; // of the sheet by what is seen from its front

Rgba rgbaOf(const Eigen::Vector3f &linear, double opacity)
{
    const Eigen::Vector3d encoded = encodedFromLinear(linear.cast<double>());
    const auto byte = [](double v) { return std::uint8_t(std::lround(255.0 * std::clamp(v, 0.0, 1.0))); };
    return {byte(encoded[0]), byte(encoded[1]), byte(encoded[2]), byte(opacity)};
}

Eigen::Vector3f linearOf(const Rgba &colour)
{
    return linearFromEncoded(Eigen::Vector3d(colour[0], colour[1], colour[2]) / 255.0).cast<float>();
}

} // namespace

CopiedStrokes copiedLines(const DoodleFrame &frame)
{
    CopiedStrokes copied;
    copied.isFlat = true;
    for (const MarkPointer &mark : frame.marks) {
        const auto *ink = std::get_if<InkStroke>(mark.get());
        if (!ink)
            continue;
        CopiedStroke stroke;
        stroke.line = ink->line;
        for (std::size_t i = 0; i < stroke.line.points.size(); ++i) {
            stroke.line.points[i].y() *= -1.0;
            const double pressure = ink->line.pressure.empty() ? 1.0 : ink->line.pressure[i];
            stroke.halfWidths.push_back(0.5 * ink->width * pressure);
        }
        stroke.colour = linearOf(ink->colour);
        stroke.opacity = ink->colour[3] / 255.0;
        copied.strokes.push_back(std::move(stroke));
    }
    return copied;
}

std::vector<InkStroke> inkStrokes(const CopiedStrokes &strokes, const Vec2 &canvasSize, double width,
                                  const Rgba &colour)
{
    const CopiedStrokes upright = inUnit(strokes, strokes.metresPerUnit, UpAxis::Y);
    Box3 box;
    for (const CopiedStroke &stroke : upright.strokes)
        for (const Vec3 &p : stroke.line.points)
            box.add(p);
    double scale = 1.0;
    Vec3 middle = Vec3::Zero();
    if (!strokes.isFlat && !box.isEmpty()) {
        const Vec3 size = (box.max - box.min).cwiseMax(1e-9 * std::max(box.diagonal(), 1e-300));
        scale = filledShare * std::min(canvasSize.x() / size.x(), canvasSize.y() / size.y());
        middle = box.centre();
    }
    std::vector<InkStroke> lines;
    for (const CopiedStroke &stroke : upright.strokes) {
        InkStroke ink;
        ink.line.timeSeconds = stroke.line.timeSeconds;
        ink.line.pressure = stroke.line.pressure;
        for (const Vec3 &p : stroke.line.points) {
            const Vec3 seen = scale * (p - middle);
            ink.line.points.emplace_back(seen.x(), -seen.y(), 0.0);
        }
        double widest = 0.0;
        for (const double half : stroke.halfWidths)
            widest = std::max(widest, half);
        ink.width = widest > 0.0 ? 2.0 * widest * scale : width;
        if (widest > 0.0) {
            ink.line.pressure.clear();
            for (const double half : stroke.halfWidths)
                ink.line.pressure.push_back(half / widest);
        }
        ink.colour = stroke.colour ? rgbaOf(*stroke.colour, stroke.opacity) : colour;
        lines.push_back(std::move(ink));
    }
    return lines;
}

Result<Doodle> withLines(const Doodle &doodle, int index, const std::vector<InkStroke> &lines)
{
    Result<Doodle> drawn = doodle;
    for (const InkStroke &line : lines)
        if (drawn)
            drawn = withMark(*drawn, index, line);
    return drawn;
}

} // namespace ductus
