#include "doodling/compositing/mark_pieces.h"

#include "doodling/canvas/mark_shape.h"
#include "doodling/compositing/stickers.h"
#include "doodling/compositing/text_outlines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double lightest = 0.25; // share of the width left at no pressure

struct Place
{
    Vec2 middle;
    double size = 1.0;
    double turn = 0.0;

    Vec2 operator()(const Vec2 &point) const { return middle + size * (Eigen::Rotation2Dd(turn) * point); }
};

void put(std::vector<MarkPiece> &pieces, const Place &place)
{
    for (MarkPiece &piece : pieces) {
        if (LinePiece *line = std::get_if<LinePiece>(&piece)) {
            for (LinePiece::Line &one : line->lines) {
                std::transform(one.points.begin(), one.points.end(), one.points.begin(), place);
                for (double &radius : one.radii)
                    radius *= place.size;
            }
        } else if (AreaPiece *area = std::get_if<AreaPiece>(&piece)) {
            for (Outline &outline : area->outlines)
                std::transform(outline.begin(), outline.end(), outline.begin(), place);
        }
    }
}

struct Pieces
{
    const TextOutlines &fonts;

    std::vector<MarkPiece> operator()(const InkStroke &ink) const
    {
        LinePiece::Line line{flatPoints(ink.line),
                             std::vector<double>(ink.line.points.size(), 0.5 * ink.width)};
        for (std::size_t i = 0; i < ink.line.pressure.size() && i < line.radii.size(); ++i)
            line.radii[i] *= lightest + (1.0 - lightest) * std::clamp(ink.line.pressure[i], 0.0, 1.0);
        return {LinePiece{{std::move(line)}, ink.colour}};
    }
    std::vector<MarkPiece> operator()(const FilledShape &shape) const
    {
        return {AreaPiece{{shape.outline}, shape.colour}};
    }
    std::vector<MarkPiece> operator()(const TextMark &text) const
    {
        constexpr double rim = 0.045; // of the line's height
        const std::vector<Outline> outlines = fonts.of(text.text, text.isBold);
        std::vector<MarkPiece> pieces;
        if (text.edge[3] > 0) {
            LinePiece edge;
            edge.colour = text.edge;
            for (Outline outline : outlines) {
                if (outline.empty())
                    continue;
                outline.push_back(outline.front());
                const std::size_t count = outline.size();
                edge.lines.push_back({std::move(outline), std::vector<double>(count, rim)});
            }
            pieces.push_back(std::move(edge));
        }
        pieces.push_back(AreaPiece{outlines, text.colour});
        put(pieces, {text.place, text.height, text.turn});
        return pieces;
    }
    std::vector<MarkPiece> operator()(const ArrowMark &arrow) const
    {
        constexpr double headLength = 4.0, headWidth = 3.6; // of the shaft's width
        const Vec2 tip = arrow.points.back();
        // The head's direction is where the last stretch of its length comes from: hands tremble.
        Outline shaft = arrow.points;
        const double length = headLength * arrow.width;
        while (shaft.size() > 1 && (shaft.back() - tip).norm() < 0.9 * length)
            shaft.pop_back();
        const Vec2 from = shaft.back();
        const Vec2 way = (tip - from).norm() > 0.0 ? (tip - from).normalized() : Vec2(1.0, 0.0);
        const Vec2 across(-way.y(), way.x());
        const Vec2 base = tip - length * way;
        if ((from - tip).norm() > 0.95 * length)
            shaft.push_back(base + 0.25 * length * way);
        LinePiece line{{{shaft, std::vector<double>(shaft.size(), 0.5 * arrow.width)}}, arrow.colour};
        const double half = 0.5 * headWidth * arrow.width;
        const Outline head = {tip, base + half * across, base + 0.2 * length * way, base - half * across};
        Outline rim = head;
        rim.push_back(tip);
        line.lines.push_back({rim, std::vector<double>(rim.size(), 0.2 * arrow.width)}); // rounds its corners
        return {std::move(line), AreaPiece{{head}, arrow.colour}};
    }
    std::vector<MarkPiece> operator()(const StickerMark &sticker) const
    {
        std::vector<MarkPiece> pieces = stickerPieces(sticker.name, sticker.colour);
        put(pieces, {sticker.place, sticker.size, sticker.turn});
        return pieces;
    }
    std::vector<MarkPiece> operator()(const PictureMark &picture) const
    {
        const Eigen::Rotation2Dd turn(picture.turn);
        const Vec2 right = turn * Vec2(picture.size.x(), 0.0), down = turn * Vec2(0.0, picture.size.y());
        return {PicturePiece{picture.image, picture.place - 0.5 * right - 0.5 * down, right, down}};
    }
};

} // namespace

std::vector<MarkPiece> piecesOf(const DoodleMark &mark, const TextOutlines &fonts)
{
    return std::visit(Pieces{fonts}, mark);
}

} // namespace ductus
