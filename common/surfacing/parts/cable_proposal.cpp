#include "surfacing/parts/cable_proposal.h"

#include "geometry/point_tree.h"
#include "strokes/resample.h"
#include "surfacing/sketch/point_cloud.h"
#include "surfacing/sketch/stray_strokes.h"
#include "surfacing/sketch/unit_frame.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace ductus {

namespace {

constexpr double step = 0.01; // of the samples, unit frame

using Touching = std::set<std::pair<int, int>>; // pairs of strokes, the lower number first

struct Samples
{
    std::vector<Vec3> points;
    std::vector<int> strokeOf;
    std::vector<int> begin; // of each stroke, and one past the last
};

// Where a stroke runs alone, and what it touches before and after.
struct Course
{
    double length = 0.0, chord = 0.0; // unit frame
    double alone = 0.0;               // the longest run, share of the length
    std::set<int> before, after;      // strokes
};

Samples samplesOf(const StrokeSet &unit)
{
    Samples samples;
    for (std::size_t s = 0; s < unit.strokes.size(); ++s) {
        samples.begin.push_back(int(samples.points.size()));
        const Stroke &stroke = unit.strokes[s];
        if (stroke.points.empty() ||
            (stroke.role != StrokeRole::Surface && stroke.role != StrokeRole::Boundary))
            continue;
        for (const Vec3 &p : resampled(stroke.points, step)) {
            samples.points.push_back(p);
            samples.strokeOf.push_back(int(s));
        }
    }
    samples.begin.push_back(int(samples.points.size()));
    return samples;
}

Course courseOf(int stroke, const Samples &samples, const PointTree &tree, double reach, Touching &touching)
{
    const int begin = samples.begin[std::size_t(stroke)], end = samples.begin[std::size_t(stroke) + 1];
    // Along the stroke its own points are near without saying anything; a coil comes back beside itself.
    const int own = int(3.0 * reach / step);
    Course course;
    std::vector<std::set<int>> near(std::size_t(end - begin));
    int runBegin = begin, bestBegin = begin, bestEnd = begin;
    for (int i = begin; i < end; ++i) {
        const Vec3 &p = samples.points[std::size_t(i)];
        if (i > begin)
            course.length += (p - samples.points[std::size_t(i - 1)]).norm();
        bool isAlone = true;
        for (int j : tree.within(p, reach)) {
            const int other = samples.strokeOf[std::size_t(j)];
            if (other == stroke) {
                isAlone &= std::abs(j - i) <= own;
                continue;
            }
            isAlone = false;
            near[std::size_t(i - begin)].insert(other);
            touching.emplace(std::min(stroke, other), std::max(stroke, other));
        }
        if (!isAlone)
            runBegin = i + 1;
        else if (i + 1 - runBegin > bestEnd - bestBegin)
            std::tie(bestBegin, bestEnd) = std::pair(runBegin, i + 1);
    }
    if (end == begin)
        return course;
    course.chord = (samples.points[std::size_t(end - 1)] - samples.points[std::size_t(begin)]).norm();
    course.alone = double(bestEnd - bestBegin) / (end - begin);
    for (int i = begin; i < bestBegin; ++i)
        course.before.insert(near[std::size_t(i - begin)].begin(), near[std::size_t(i - begin)].end());
    for (int i = bestEnd; i < end; ++i)
        course.after.insert(near[std::size_t(i - begin)].begin(), near[std::size_t(i - begin)].end());
    return course;
}

// Whether strokes touch their way from one end of the stroke to the other without it.
bool isWayAround(int stroke, const Course &course, int strokeCount, const Touching &touching)
{
    std::vector<int> root(std::size_t(strokeCount), 0);
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&](int s) {
        while (root[std::size_t(s)] != s)
            s = root[std::size_t(s)] = root[std::size_t(root[std::size_t(s)])];
        return s;
    };
    for (const auto &[a, b] : touching)
        if (a != stroke && b != stroke)
            root[std::size_t(find(a))] = find(b);
    for (int a : course.before)
        for (int b : course.after)
            if (find(a) == find(b))
                return true;
    return false;
}

} // namespace

Result<std::vector<int>> proposedCables(const StrokeSet &strokes, const CableOptions &options,
                                        const JobControl &control)
{
    std::vector<int> cables;
    if (isPointCloud(strokes))
        return cables;
    const StrokeSet drawn = withStraysIgnored(strokes).strokes;
    const Samples samples = samplesOf(inUnitFrame(drawn, unitFrameOf(drawn)));
    const PointTree tree(samples.points);
    const int count = int(strokes.strokes.size());
    Touching touching;
    std::vector<Course> courses;
    for (int s = 0; s < count; ++s) {
        if (control.isCancelled())
            return cancelledError("Looking for cables");
        courses.push_back(courseOf(s, samples, tree, options.reach, touching));
    }
    for (int s = 0; s < count; ++s) {
        const Course &course = courses[std::size_t(s)];
        const bool isDangling = course.before.empty() || course.after.empty();
        if (strokes.strokes[std::size_t(s)].role != StrokeRole::Surface ||
            course.length < options.leastLength || course.chord < options.leastChord * course.length ||
            course.alone < (isDangling ? options.leastDangling : options.leastAlone) ||
            (course.before.empty() && course.after.empty())) // hangs on nothing: all of a sparse sketch
            continue;
        if (control.isCancelled())
            return cancelledError("Looking for cables");
        if (!isWayAround(s, course, count, touching))
            cables.push_back(s);
    }
    if (int(cables.size()) > options.mostCables)
        cables.clear();
    return cables;
}

Result<std::vector<int>> markCables(StrokeSet &strokes, const CableOptions &options,
                                    const JobControl &control)
{
    const StrokeSet once = cleaned(strokes);
    if (int(once.strokes.size()) > options.mostStrokes)
        return std::vector<int>();
    const Result<std::vector<int>> proposed = proposedCables(once, options, control);
    if (!proposed)
        return proposed.error();
    std::set<int> ids;
    for (int s : *proposed)
        ids.insert(once.strokes[std::size_t(s)].id.value);
    std::vector<int> cables;
    for (std::size_t s = 0; s < strokes.strokes.size(); ++s)
        if (ids.count(strokes.strokes[s].id.value) > 0) {
            strokes.strokes[s].role = StrokeRole::Skeletal;
            cables.push_back(int(s));
        }
    return cables;
}

} // namespace ductus
