// What is drawn on a canvas: marks, in frames that are shown one after another. Plain values; marks are
// shared between copies and never changed, so a copy of a whole scene costs little.
//
// Canvas units: x right, y down, the canvas' middle at 0, 0; a canvas of size 1 x 1 is 1 scene unit wide
// where its scale is 1.
#pragma once

#include "doodling/scene/shot_camera.h"
#include "imaging/image.h"
#include "strokes/stroke.h"

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace ductus {

/// A line drawn by hand. Points in canvas units, z is 0. As wide as \a width where the pressure is 1 or not
/// known.
struct InkStroke
{
    Stroke line;
    Rgba colour = {20, 20, 20, 255};
    double width = 0.02;
};

/// An area within a closed outline; where it crosses itself, what is encircled more than zero times is in.
struct FilledShape
{
    std::vector<Vec2> outline;
    Rgba colour = {255, 220, 60, 255};
};

/// Words, UTF-8, lines parted by '\n', centred on \a place. \a height: of a line. \a edge: a rim of a quarter
/// of a letter's stem in that colour, so that words can be read on anything; alpha 0: none.
struct TextMark
{
    std::string text;
    Vec2 place = Vec2::Zero();
    double height = 0.15;
    double turn = 0.0; // clockwise, radians
    bool isBold = true;
    Rgba colour = {20, 20, 20, 255};
    Rgba edge = {255, 255, 255, 255};
};

/// Along \a points, the head at the last one.
struct ArrowMark
{
    std::vector<Vec2> points;
    double width = 0.03;
    Rgba colour = {220, 40, 40, 255};
};

/// One of the ready-made drawings, see stickerNames().
struct StickerMark
{
    std::string name;
    Vec2 place = Vec2::Zero();
    double size = 0.3; // of its square
    double turn = 0.0; // clockwise, radians
    Rgba colour = {250, 190, 30, 255};
};

/// A picture from a file, its middle on \a place.
struct PictureMark
{
    std::shared_ptr<const Image> image; // not null
    Vec2 place = Vec2::Zero();
    Vec2 size = Vec2(0.5, 0.5);
    double turn = 0.0; // clockwise, radians
};

using DoodleMark = std::variant<InkStroke, FilledShape, TextMark, ArrowMark, StickerMark, PictureMark>;
using MarkPointer = std::shared_ptr<const DoodleMark>;

struct DoodleFrame
{
    std::vector<MarkPointer> marks; // lowest first; none is null
    int hold = 1;                   // video frames it is shown, >= 1
};

/// What comes after the last frame. Loop and PingPong also fill the time before the first one. PingPong shows
/// the two ends once a turn. Once: nothing before and after. HoldLast: nothing before, the last frame after.
enum class DoodleRepeat { Loop, PingPong, Once, HoldLast };

struct Doodle
{
    std::vector<DoodleFrame> frames = std::vector<DoodleFrame>(1); // at least one
    DoodleRepeat repeat = DoodleRepeat::Loop;
    int offset = 0; // the video frame at which the first one begins; may be negative
};

} // namespace ductus
