#include "doodling/compositing/layer.h"

#include "base/parallel.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

void over(float *below, float share, const std::array<float, 3> &colour)
{
    for (std::size_t c = 0; c < 3; ++c)
        below[c] = share * colour[c] + (1.0f - share) * below[c];
    below[3] = share + (1.0f - share) * below[3];
}

void paint(PaintedLayer &layer, const Coverage &coverage, const Rgba &colour)
{
    const std::array<float, 3> unit = {colour[0] / 255.0f, colour[1] / 255.0f, colour[2] / 255.0f};
    const float opacity = colour[3] / 255.0f;
    const float *share = coverage.shares.data();
    for (int y = coverage.box.top; y < coverage.box.bottom; ++y) {
        float *p = layer.at(coverage.box.left, y);
        for (int x = coverage.box.left; x < coverage.box.right; ++x, ++share, p += 4)
            if (*share > 0.0f)
                over(p, *share * opacity, unit);
    }
}

// The picture's colour around (u, v) in its pixels, premultiplied; nothing outside.
std::array<float, 4> sampled(const Image &image, double u, double v)
{
    const double x = u - 0.5, y = v - 0.5;
    const int left = int(std::floor(x)), top = int(std::floor(y));
    std::array<float, 4> sum{};
    for (int dy = 0; dy < 2; ++dy)
        for (int dx = 0; dx < 2; ++dx) {
            const int px = left + dx, py = top + dy;
            if (px < 0 || py < 0 || px >= image.width || py >= image.height)
                continue;
            const double weight = (dx ? x - left : 1.0 - x + left) * (dy ? y - top : 1.0 - y + top);
            const Rgba colour = image.at(px, py);
            const float alpha = float(weight) * colour[3] / 255.0f;
            for (std::size_t c = 0; c < 3; ++c)
                sum[c] += alpha * colour[c] / 255.0f;
            sum[3] += alpha;
        }
    return sum;
}

void paintPicture(PaintedLayer &layer, const PicturePiece &picture, const CanvasView &view)
{
    const Image &image = *picture.image;
    Eigen::Matrix2d sides;
    sides.col(0) = picture.right;
    sides.col(1) = picture.down;
    const Eigen::Matrix2d shareFromCanvas = sides.inverse();
    const PixelBox box = boxOf(picture, view, layer.box);
    // Pictures seen small are averaged over as many of their pixels as fall into one.
    const double shrink = std::max(image.width / std::max(1e-9, picture.right.norm() * view.pixelsAUnit()),
                                   image.height / std::max(1e-9, picture.down.norm() * view.pixelsAUnit()));
    const int samples = std::clamp(int(std::ceil(shrink)), 2, 6);
    for (int y = box.top; y < box.bottom; ++y)
        for (int x = box.left; x < box.right; ++x) {
            std::array<float, 4> sum{};
            for (int s = 0; s < samples * samples; ++s) {
                const Vec2 pixel(x + (s % samples + 0.5) / samples, y + (s / samples + 0.5) / samples);
                const std::optional<Vec2> onCanvas = view.canvasPointOf(pixel);
                if (!onCanvas)
                    continue;
                const Vec2 share = shareFromCanvas * (*onCanvas - picture.corner);
                if (share.minCoeff() < 0.0 || share.maxCoeff() > 1.0)
                    continue;
                const std::array<float, 4> colour =
                    sampled(image, share.x() * image.width, share.y() * image.height);
                for (std::size_t c = 0; c < 4; ++c)
                    sum[c] += colour[c];
            }
            float *p = layer.at(x, y);
            const float unit = 1.0f / float(samples * samples);
            for (std::size_t c = 0; c < 4; ++c)
                p[c] = sum[c] * unit + (1.0f - sum[3] * unit) * p[c];
        }
}

} // namespace

PaintedLayer paintedPieces(const std::vector<MarkPiece> &pieces, const CanvasView &view,
                           const PixelBox &limits)
{
    PaintedLayer layer;
    std::vector<PixelBox> boxes;
    for (const MarkPiece &piece : pieces) {
        boxes.push_back(boxOf(piece, view, limits));
        layer.box = layer.box.joined(boxes.back());
    }
    if (layer.box.isEmpty())
        return layer;
    layer.pixels.assign(4 * std::size_t(layer.box.width()) * std::size_t(layer.box.height()), 0.0f);
    // Coverages do not depend on each other, only their order does.
    std::vector<Coverage> coverages(pieces.size());
    parallelFor(0, pieces.size(), [&](std::size_t i) {
        if (boxes[i].isEmpty())
            return;
        if (const LinePiece *line = std::get_if<LinePiece>(&pieces[i]))
            coverages[i] = lineCoverage(*line, view, layer.box);
        else if (const AreaPiece *area = std::get_if<AreaPiece>(&pieces[i]))
            coverages[i] = areaCoverage(*area, view, layer.box);
    });
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (boxes[i].isEmpty())
            continue;
        if (const LinePiece *line = std::get_if<LinePiece>(&pieces[i]))
            paint(layer, coverages[i], line->colour);
        else if (const AreaPiece *area = std::get_if<AreaPiece>(&pieces[i]))
            paint(layer, coverages[i], area->colour);
        else
            paintPicture(layer, std::get<PicturePiece>(pieces[i]), view);
        coverages[i] = {};
    }
    return layer;
}

void layOver(const PaintedLayer &layer, Image &picture)
{
    for (int y = layer.box.top; y < layer.box.bottom; ++y) {
        const float *from = layer.at(layer.box.left, y);
        std::uint8_t *to = picture.pixels.data() +
                           4 * (std::size_t(y) * std::size_t(picture.width) + std::size_t(layer.box.left));
        for (int x = layer.box.left; x < layer.box.right; ++x, from += 4, to += 4) {
            if (from[3] <= 0.0f)
                continue;
            const float below = (1.0f - from[3]) * to[3] / 255.0f;
            const float alpha = from[3] + below;
            for (std::size_t c = 0; c < 3; ++c)
                to[c] =
                    std::uint8_t(std::clamp((255.0f * from[c] + below * to[c]) / alpha + 0.5f, 0.0f, 255.0f));
            to[3] = std::uint8_t(std::clamp(255.0f * alpha + 0.5f, 0.0f, 255.0f));
        }
    }
}

} // namespace ductus
