#include "surfacing/parts/centre_line.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ductus {

namespace {

constexpr double steepestTaper = 0.5;    // change of radius along the line; steeper, sides look like steps
constexpr double spareBetween = 0.9;     // of the radius at which neighbouring sections would touch
constexpr int mostRounds = 400;          // of smoothing; a corner of 90 degrees takes about thirty
constexpr double leastTurnCosine = -0.2; // of neighbouring segments; beyond, no common section divides them

double lengthOf(const std::vector<Vec3> &points)
{
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i)
        length += (points[i] - points[i - 1]).norm();
    return length;
}

// Points and radii at even steps; both ends are kept.
void makeEven(std::vector<Vec3> &points, std::vector<double> &radii, double step)
{
    const double length = lengthOf(points);
    const int count = std::max(2, int(std::ceil(length / step)));
    std::vector<Vec3> evenPoints;
    std::vector<double> evenRadii;
    double before = 0.0; // arc length at the start of segment s
    std::size_t s = 1;
    for (int i = 0; i < count; ++i) {
        const double wanted = length * i / (count - 1);
        double segment = (points[s] - points[s - 1]).norm();
        while (s + 1 < points.size() && before + segment < wanted) {
            before += segment;
            ++s;
            segment = (points[s] - points[s - 1]).norm();
        }
        const double f = segment > 0.0 ? std::clamp((wanted - before) / segment, 0.0, 1.0) : 0.0;
        evenPoints.push_back((1.0 - f) * points[s - 1] + f * points[s]);
        evenRadii.push_back((1.0 - f) * radii[s - 1] + f * radii[s]);
    }
    evenPoints.back() = points.back();
    points = std::move(evenPoints);
    radii = std::move(evenRadii);
}

// Rounds bends that are too tight: each point of one moves towards the middle of its neighbours, never
// farther than allowed from where it was drawn.
void roundBends(std::vector<Vec3> &points, const std::vector<double> &radii, bool isLoop,
                const TubeOptions &options)
{
    const std::vector<Vec3> drawn = points;
    const std::size_t n = points.size();
    std::vector<Vec3> next = points;
    for (int round = 0; round < mostRounds; ++round) {
        bool isDone = true;
        for (std::size_t i = isLoop ? 0 : 1; i < (isLoop ? n : n - 1); ++i) {
            const Vec3 &a = points[(i + n - 1) % n], &b = points[i], &c = points[(i + 1) % n];
            // Circle through the three points: its radius is |ab| |bc| |ca| / (4 area).
            const double fourAreas = 2.0 * (b - a).cross(c - a).norm();
            const double product = (b - a).norm() * (c - b).norm() * (c - a).norm();
            const bool turnsBack = (b - a).dot(c - b) < 0.0;
            if (!turnsBack && product >= options.tightestBend * radii[i] * fourAreas)
                continue;
            Vec3 moved = 0.5 * b + 0.25 * (a + c);
            const Vec3 shift = moved - drawn[i];
            const double most = options.farthestShift * radii[i];
            if (shift.norm() > most)
                moved = drawn[i] + shift * (most / shift.norm());
            if ((moved - b).norm() > 1e-4 * radii[i])
                isDone = false;
            next[i] = moved;
        }
        points = next;
        if (isDone)
            return;
    }
}

std::vector<Vec3> tangentsOf(const std::vector<Vec3> &points, bool isLoop)
{
    const std::size_t n = points.size();
    std::vector<Vec3> tangents(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 &before = i > 0 ? points[i - 1] : isLoop ? points[n - 1] : points[0];
        const Vec3 &after = i + 1 < n ? points[i + 1] : isLoop ? points[0] : points[n - 1];
        // Of the two directions, not of the chord: at ends and uneven steps it halves the turn.
        const Vec3 in = points[i] - before, out = after - points[i];
        Vec3 sum = (in.norm() > 0.0 ? in.normalized() : Vec3::Zero()) +
                   (out.norm() > 0.0 ? out.normalized() : Vec3::Zero());
        tangents[i] = sum.norm() > 1e-9 ? Vec3(sum.normalized()) : i > 0 ? tangents[i - 1] : Vec3::UnitX();
    }
    return tangents;
}

// A section of radius r ends before the plane of its neighbour if r sin(angle between them) is less than the
// distance of its centre from that plane.
void limitRadii(CentreLine &line)
{
    const int n = line.size();
    for (int i = 0; i < (line.isLoop ? n : n - 1); ++i) {
        const auto a = std::size_t(i), b = std::size_t((i + 1) % n);
        const Vec3 d = line.points[b] - line.points[a];
        const double sine = line.tangents[a].cross(line.tangents[b]).norm();
        if (sine < 1e-9)
            continue;
        line.radii[a] = std::min(line.radii[a], spareBetween * std::max(0.0, d.dot(line.tangents[b])) / sine);
        line.radii[b] = std::min(line.radii[b], spareBetween * std::max(0.0, d.dot(line.tangents[a])) / sine);
    }
    const auto taper = [&](int from, int to) {
        const auto a = std::size_t((from + n) % n), b = std::size_t((to + n) % n);
        line.radii[b] =
            std::min(line.radii[b], line.radii[a] + steepestTaper * (line.points[b] - line.points[a]).norm());
    };
    const int rounds = line.isLoop ? 2 * n : n;
    for (int i = 1; i < rounds; ++i)
        taper((i - 1) % n, i % n);
    for (int i = rounds - 1; i > 0; --i)
        taper(i % n, (i - 1) % n);
}

CentreLine finished(std::vector<Vec3> points, std::vector<double> radii, bool isLoop)
{
    CentreLine line{std::move(points), std::move(radii), {}, isLoop};
    line.tangents = tangentsOf(line.points, isLoop);
    limitRadii(line);
    return line;
}

} // namespace

std::vector<CentreLine> centreLines(const std::vector<Vec3> &given, const std::vector<double> &givenRadii,
                                    const TubeOptions &options)
{
    std::vector<Vec3> points = given;
    std::vector<double> radii = givenRadii;
    const double length = lengthOf(points);
    double mean = 0.0;
    for (double r : radii)
        mean += r / double(radii.size());
    const double thinnest = *std::min_element(radii.begin(), radii.end());
    const double step =
        std::max(options.stepInRadii * std::max(thinnest, 0.5 * mean), length / options.mostSections);
    const bool isLoop = (points.front() - points.back()).norm() <= 2.0 * mean &&
                        length >= options.loopLength * 2.0 * std::numbers::pi * mean;
    if (isLoop) {
        points.push_back(points.front());
        radii.push_back(radii.front());
    }
    makeEven(points, radii, step);
    if (isLoop) {
        points.pop_back();
        radii.pop_back();
    }
    roundBends(points, radii, isLoop, options);

    std::vector<CentreLine> lines;
    std::vector<Vec3> piece{points.front()};
    std::vector<double> pieceRadii{radii.front()};
    bool wasSplit = false;
    const std::size_t n = points.size();
    const double bunched = 0.05 * length / double(n);
    for (std::size_t i = 1; i < n; ++i) {
        const Vec3 toNext = points[i] - piece.back();
        if (!(toNext.norm() > bunched)) { // bunched up by the rounding: nothing to make a section of
            if (i + 1 == n && piece.size() > 1 && !isLoop)
                piece.back() = points[i];
            continue;
        }
        if (piece.size() > 1) {
            const Vec3 in = (piece.back() - piece[piece.size() - 2]).normalized();
            if (in.dot(toNext.normalized()) < leastTurnCosine) {
                const Vec3 joint = piece.back();
                const double radius = pieceRadii.back();
                lines.push_back(finished(std::move(piece), std::move(pieceRadii), false));
                piece = {joint};
                pieceRadii = {radius};
                wasSplit = true;
            }
        }
        piece.push_back(points[i]);
        pieceRadii.push_back(radii[i]);
    }
    if (isLoop && wasSplit) { // the seam of the loop is a joint as well
        piece.push_back(points.front());
        pieceRadii.push_back(radii.front());
    }
    if (piece.size() > 1)
        lines.push_back(finished(std::move(piece), std::move(pieceRadii), isLoop && !wasSplit));
    return lines;
}

} // namespace ductus
