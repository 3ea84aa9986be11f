#include "strokes/bend.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double closedShare = 1e-9; // of the length, between beginning and end
constexpr int stepsInReach = 12;     // points a bend needs on each of its sides to look like a curve

std::vector<double> arcLengths(const std::vector<Vec3> &points)
{
    std::vector<double> along(points.size(), 0.0);
    for (std::size_t i = 1; i < points.size(); ++i)
        along[i] = along[i - 1] + (points[i] - points[i - 1]).norm();
    return along;
}

bool isClosed(const std::vector<Vec3> &points, double length)
{
    return points.size() > 3 && (points.front() - points.back()).norm() <= closedShare * length;
}

// How much of the way each place takes: 1 at the handle, falling with a flat top and a flat foot (biweight),
// so that the bent stroke has no kink where it had none.
class Falloff
{
public:
    Falloff(const std::vector<Vec3> &points, double length, const StrokeBend &bend)
        : mAt(std::clamp(bend.along, 0.0, length)), mLength(length), mIsClosed(isClosed(points, length))
    {
        mBefore = mAfter = std::min(bend.reach, mIsClosed ? 0.5 * length : length);
        if (mIsClosed || !bend.endsArePinned)
            return;
        // An end that is dragged itself is not pinned, and neither is the other one seen from it.
        if (mAt > 0.0)
            mBefore = std::min(mBefore, mAt);
        if (mAt < length)
            mAfter = std::min(mAfter, length - mAt);
    }

    double at(double along) const
    {
        double way = along - mAt;
        if (mIsClosed)
            way -= mLength * std::round(way / mLength);
        const double reach = way < 0.0 ? mBefore : mAfter;
        const double share = reach > 0.0 ? std::abs(way) / reach : (way == 0.0 ? 0.0 : 1.0);
        return share >= 1.0 ? 0.0 : (1.0 - share * share) * (1.0 - share * share);
    }

    // Parts a segment must have so that it can follow.
    int partsOf(double from, double to) const
    {
        const double step =
            std::min(mBefore > 0.0 ? mBefore : mAfter, mAfter > 0.0 ? mAfter : mBefore) / stepsInReach;
        if (step <= 0.0 || !touches(from, to))
            return 1;
        return std::max(1, int(std::ceil((to - from) / step - 1e-6)));
    }

private:
    bool touches(double from, double to) const
    {
        for (const double turn : {-mLength, 0.0, mLength})
            if ((turn == 0.0 || mIsClosed) && from < mAt + turn + mAfter && to > mAt + turn - mBefore)
                return true;
        return false;
    }

    double mAt, mLength;
    bool mIsClosed;
    double mBefore = 0.0, mAfter = 0.0;
};

double between(const std::vector<double> &channel, std::size_t i, double share)
{
    return (1.0 - share) * channel[i] + share * channel[i + 1];
}

} // namespace

bool isClosedLine(const std::vector<Vec3> &points)
{
    return isClosed(points, polylineLength(points));
}

std::vector<StrokeHandle> strokeHandles(const std::vector<Vec3> &points, int count)
{
    const std::vector<double> along = arcLengths(points);
    if (points.size() < 2 || along.back() <= 0.0)
        return {};
    count = std::max(count, 2);
    const int steps = isClosed(points, along.back()) ? count : count - 1;
    std::vector<StrokeHandle> handles;
    std::size_t segment = 1;
    for (int i = 0; i < count; ++i) {
        const double at = along.back() * i / steps;
        while (segment + 1 < points.size() && along[segment] < at)
            ++segment;
        const double length = along[segment] - along[segment - 1];
        const double share = length > 0.0 ? std::clamp((at - along[segment - 1]) / length, 0.0, 1.0) : 0.0;
        handles.push_back({at, (1.0 - share) * points[segment - 1] + share * points[segment]});
    }
    return handles;
}

Stroke bentStroke(const Stroke &stroke, const StrokeBend &bend)
{
    const std::vector<Vec3> &points = stroke.points;
    const std::vector<double> along = arcLengths(points);
    if (points.size() < 2 || along.back() <= 0.0 || bend.reach <= 0.0)
        return stroke;
    const Falloff falloff(points, along.back(), bend);
    Stroke bent;
    bent.id = stroke.id;
    bent.role = stroke.role;
    const auto add = [&](std::size_t i, double share) {
        const std::size_t next = std::min(i + 1, points.size() - 1);
        const double at = (1.0 - share) * along[i] + share * along[next];
        const Vec3 point = share > 0.0 ? Vec3((1.0 - share) * points[i] + share * points[next]) : points[i];
        const double weight = falloff.at(at);
        bent.points.push_back(weight > 0.0 ? Vec3(point + weight * bend.way) : point);
        if (stroke.pressure.size() == points.size())
            bent.pressure.push_back(share > 0.0 ? between(stroke.pressure, i, share) : stroke.pressure[i]);
        if (stroke.timeSeconds.size() == points.size())
            bent.timeSeconds.push_back(share > 0.0 ? between(stroke.timeSeconds, i, share)
                                                   : stroke.timeSeconds[i]);
    };
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const int parts = falloff.partsOf(along[i], along[i + 1]);
        for (int part = 0; part < parts; ++part)
            add(i, double(part) / parts);
    }
    add(points.size() - 1, 0.0);
    if (points.front() == points.back())
        bent.points.back() = bent.points.front(); // whatever the rounding
    return bent;
}

std::vector<Vec3> bentLine(const std::vector<Vec3> &points, const StrokeBend &bend)
{
    Stroke stroke;
    stroke.points = points;
    return bentStroke(stroke, bend).points;
}

} // namespace ductus
