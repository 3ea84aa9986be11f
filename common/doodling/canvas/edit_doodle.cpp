#include "doodling/canvas/edit_doodle.h"

#include "doodling/canvas/mark_shape.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

Error refused(const std::string &attempted, const std::string &problem)
{
    return {ErrorCode::InvalidArgument, attempted, problem, "", ""};
}

bool isFrame(const Doodle &doodle, int index)
{
    return index >= 0 && index < int(doodle.frames.size());
}

Error noFrame(const std::string &attempted)
{
    return refused(attempted, "there is no such frame in the doodle");
}

bool areFinite(const std::vector<Vec2> &points)
{
    return std::all_of(points.begin(), points.end(), [](const Vec2 &p) { return p.allFinite(); });
}

// What is wrong with a mark; empty: nothing.
struct Problem
{
    std::string operator()(const InkStroke &ink) const
    {
        const std::size_t count = ink.line.points.size();
        if (count == 0 || !areFinite(flatPoints(ink.line)))
            return "the line has no points";
        if ((!ink.line.pressure.empty() && ink.line.pressure.size() != count) ||
            (!ink.line.timeSeconds.empty() && ink.line.timeSeconds.size() != count))
            return "the line has pressures or times for other points than it has";
        return ink.width > 0.0 && std::isfinite(ink.width) ? "" : "the line has no width";
    }
    std::string operator()(const FilledShape &shape) const
    {
        return shape.outline.size() >= 3 && areFinite(shape.outline) ? "" : "the area has no outline";
    }
    std::string operator()(const TextMark &text) const
    {
        if (text.text.empty())
            return "there are no words";
        return isSize(text.height) && isPlace(text.place, text.turn) ? "" : "the words have no size or place";
    }
    std::string operator()(const ArrowMark &arrow) const
    {
        if (arrow.points.size() < 2 || !areFinite(arrow.points))
            return "the arrow leads nowhere";
        return isSize(arrow.width) ? "" : "the arrow has no width";
    }
    std::string operator()(const StickerMark &sticker) const
    {
        return isSize(sticker.size) && isPlace(sticker.place, sticker.turn)
                   ? ""
                   : "the sticker has no size or place";
    }
    std::string operator()(const PictureMark &picture) const
    {
        if (!picture.image || picture.image->width < 1 || picture.image->height < 1)
            return "there is no picture";
        return isSize(picture.size.minCoeff()) && picture.size.allFinite() &&
                       isPlace(picture.place, picture.turn)
                   ? ""
                   : "the picture has no size or place";
    }

    static bool isSize(double size) { return size > 0.0 && std::isfinite(size); }
    static bool isPlace(const Vec2 &place, double turn) { return place.allFinite() && std::isfinite(turn); }
};

// The pieces of a line outside of the eraser; cut where a segment crosses its rim, found by halving.
std::vector<InkStroke> remaining(const InkStroke &ink, const std::vector<Vec2> &path, double radius)
{
    const auto isErased = [&](const Vec3 &p) { return distanceToLine(p.head<2>(), path) < radius; };
    const auto hasPressure = !ink.line.pressure.empty(), hasTime = !ink.line.timeSeconds.empty();
    std::vector<InkStroke> pieces;
    InkStroke piece = ink;
    const auto clear = [&] {
        piece.line.points.clear();
        piece.line.pressure.clear();
        piece.line.timeSeconds.clear();
    };
    const auto append = [&](std::size_t i, double share) { // share of the way to i + 1
        const auto mixed = [&](const auto &values) {
            return share > 0.0 ? (values[i] + share * (values[i + 1] - values[i])) : values[i];
        };
        if (share > 0.0)
            piece.line.points.push_back(ink.line.points[i] +
                                        share * (ink.line.points[i + 1] - ink.line.points[i]));
        else
            piece.line.points.push_back(ink.line.points[i]);
        if (hasPressure)
            piece.line.pressure.push_back(mixed(ink.line.pressure));
        if (hasTime)
            piece.line.timeSeconds.push_back(mixed(ink.line.timeSeconds));
    };
    const auto close = [&] {
        if (piece.line.points.size() >= 2 || (piece.line.points.size() == 1 && ink.line.points.size() == 1))
            pieces.push_back(piece);
        clear();
    };
    clear();
    const std::vector<Vec3> &points = ink.line.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!isErased(points[i]))
            append(i, 0.0);
        if (i + 1 == points.size())
            break;
        // Long segments may cross the eraser and come out again: looked at in steps of half its radius.
        const double length = (points[i + 1] - points[i]).norm();
        const int steps = std::clamp(int(std::ceil(length / (0.5 * radius))), 1, 4096);
        bool isIn = isErased(points[i]);
        for (int s = 1; s <= steps; ++s) {
            const auto at = [&](double share) {
                return Vec3(points[i] + share * (points[i + 1] - points[i]));
            };
            const bool isNextIn = isErased(at(double(s) / steps));
            if (isNextIn == isIn)
                continue;
            double low = double(s - 1) / steps, high = double(s) / steps;
            for (int halving = 0; halving < 20; ++halving) {
                const double middle = 0.5 * (low + high);
                (isErased(at(middle)) == isIn ? low : high) = middle;
            }
            append(i, isIn ? high : low);
            if (isNextIn)
                close();
            isIn = isNextIn;
        }
    }
    close();
    return pieces;
}

bool isTouched(const DoodleMark &mark, const std::vector<Vec2> &path, double radius)
{
    const double step = 0.5 * radius;
    for (std::size_t i = 0; i < path.size(); ++i) {
        if (distanceToMark(path[i], mark) < radius)
            return true;
        if (i + 1 == path.size())
            break;
        const int steps = std::clamp(int((path[i + 1] - path[i]).norm() / step), 0, 4096);
        for (int s = 1; s <= steps; ++s)
            if (distanceToMark(path[i] + double(s) / (steps + 1) * (path[i + 1] - path[i]), mark) < radius)
                return true;
    }
    return false;
}

struct Shift
{
    Vec2 by;

    void operator()(InkStroke &ink) const
    {
        for (Vec3 &point : ink.line.points)
            point.head<2>() += by;
    }
    void operator()(FilledShape &shape) const
    {
        for (Vec2 &point : shape.outline)
            point += by;
    }
    void operator()(ArrowMark &arrow) const
    {
        for (Vec2 &point : arrow.points)
            point += by;
    }
    template <typename Placed>
    void operator()(Placed &mark) const
    {
        mark.place += by;
    }
};

} // namespace

Result<Doodle> withMark(const Doodle &doodle, int index, DoodleMark mark)
{
    if (!isFrame(doodle, index))
        return noFrame("Drawing");
    if (const std::string problem = std::visit(Problem{}, mark); !problem.empty())
        return refused("Drawing", problem);
    Doodle result = doodle;
    result.frames[std::size_t(index)].marks.push_back(std::make_shared<const DoodleMark>(std::move(mark)));
    return result;
}

Result<Doodle> withoutMark(const Doodle &doodle, int index, const MarkPointer &mark)
{
    if (!isFrame(doodle, index))
        return noFrame("Removing the mark");
    Doodle result = doodle;
    if (std::erase(result.frames[std::size_t(index)].marks, mark) == 0)
        return refused("Removing the mark", "it is not there any more");
    return result;
}

Result<Doodle> withChangedMark(const Doodle &doodle, int index, const MarkPointer &old, DoodleMark mark)
{
    if (!isFrame(doodle, index))
        return noFrame("Changing the mark");
    if (const std::string problem = std::visit(Problem{}, mark); !problem.empty())
        return refused("Changing the mark", problem);
    Doodle result = doodle;
    std::vector<MarkPointer> &marks = result.frames[std::size_t(index)].marks;
    const auto place = std::find(marks.begin(), marks.end(), old);
    if (place == marks.end())
        return refused("Changing the mark", "it is not there any more");
    *place = std::make_shared<const DoodleMark>(std::move(mark));
    return result;
}

Result<Doodle> withErased(const Doodle &doodle, int index, const std::vector<Vec2> &path, double radius)
{
    if (!isFrame(doodle, index))
        return noFrame("Erasing");
    if (path.empty() || !areFinite(path) || !(radius > 0.0) || !std::isfinite(radius))
        return refused("Erasing", "the eraser has no place or no size");
    Doodle result = doodle;
    std::vector<MarkPointer> kept;
    for (const MarkPointer &mark : doodle.frames[std::size_t(index)].marks) {
        const InkStroke *ink = std::get_if<InkStroke>(mark.get());
        if (!isTouched(*mark, path, radius)) {
            kept.push_back(mark);
        } else if (ink) {
            const double reach = radius + 0.5 * ink->width; // what is left does not reach in with its width
            for (InkStroke &piece : remaining(*ink, path, reach))
                kept.push_back(std::make_shared<const DoodleMark>(std::move(piece)));
        }
    }
    result.frames[std::size_t(index)].marks = std::move(kept);
    return result;
}

Result<Doodle> withInsertedFrame(const Doodle &doodle, int index, int hold)
{
    if (index < 0 || index > int(doodle.frames.size()) || hold < 1)
        return refused("Inserting a frame", "there is no such place, or it would be shown for no time");
    Doodle result = doodle;
    result.frames.insert(result.frames.begin() + index, DoodleFrame{{}, hold});
    return result;
}

Result<Doodle> withDuplicatedFrame(const Doodle &doodle, int index)
{
    if (!isFrame(doodle, index))
        return noFrame("Doubling the frame");
    Doodle result = doodle;
    result.frames.insert(result.frames.begin() + index + 1, doodle.frames[std::size_t(index)]);
    return result;
}

Result<Doodle> withoutFrame(const Doodle &doodle, int index)
{
    if (!isFrame(doodle, index))
        return noFrame("Removing the frame");
    if (doodle.frames.size() == 1)
        return refused("Removing the frame", "it is the only one");
    Doodle result = doodle;
    result.frames.erase(result.frames.begin() + index);
    return result;
}

Result<Doodle> withMovedFrame(const Doodle &doodle, int from, int to)
{
    if (!isFrame(doodle, from) || !isFrame(doodle, to))
        return noFrame("Moving the frame");
    Doodle result = doodle;
    DoodleFrame frame = std::move(result.frames[std::size_t(from)]);
    result.frames.erase(result.frames.begin() + from);
    result.frames.insert(result.frames.begin() + to, std::move(frame));
    return result;
}

Result<Doodle> withHold(const Doodle &doodle, int index, int hold)
{
    if (!isFrame(doodle, index))
        return noFrame("Changing how long the frame is shown");
    if (hold < 1)
        return refused("Changing how long the frame is shown", "it would be shown for no time");
    Doodle result = doodle;
    result.frames[std::size_t(index)].hold = hold;
    return result;
}

DoodleMark movedMark(const DoodleMark &mark, const Vec2 &shift)
{
    DoodleMark moved = mark;
    std::visit(Shift{shift}, moved);
    return moved;
}

MarkPointer markAt(const DoodleFrame &frame, const Vec2 &point, double reach)
{
    for (auto mark = frame.marks.rbegin(); mark != frame.marks.rend(); ++mark)
        if (distanceToMark(point, **mark) <= reach)
            return *mark;
    return nullptr;
}

} // namespace ductus
