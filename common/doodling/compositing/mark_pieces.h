// What marks are made of when they are painted: lines, areas and pictures in canvas units.
#pragma once

#include "base/result.h"
#include "doodling/canvas/doodle.h"

namespace ductus {

using Outline = std::vector<Vec2>;

/// Round strokes along lines, in one colour: where they cross nothing is painted twice.
struct LinePiece
{
    struct Line
    {
        Outline points;
        std::vector<double> radii; // one a point, canvas units
    };
    std::vector<Line> lines;
    Rgba colour{};
};

/// What closed outlines go round, in one colour; winding numbers other than 0 are in.
struct AreaPiece
{
    std::vector<Outline> outlines;
    Rgba colour{};
};

/// A picture on the parallelogram corner, corner + right, corner + down.
struct PicturePiece
{
    std::shared_ptr<const Image> image;
    Vec2 corner, right, down;
};

using MarkPiece = std::variant<LinePiece, AreaPiece, PicturePiece>;

class TextOutlines;

/// Lowest first. Words whose font cannot be found come as boxes of their size.
std::vector<MarkPiece> piecesOf(const DoodleMark &mark, const TextOutlines &fonts);

} // namespace ductus
