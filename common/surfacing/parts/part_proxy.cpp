#include "surfacing/parts/part_proxy.h"

#include "geometry/point_tree.h"
#include "strokes/resample.h"
#include "surfacing/sketch/unit_frame.h"

#include <algorithm>
#include <numeric>

namespace ductus {

namespace {

constexpr double step = 0.01; // of the samples, unit frame

bool carriesSurface(const Stroke &stroke)
{
    return !stroke.points.empty() &&
           (stroke.role == StrokeRole::Surface || stroke.role == StrokeRole::Boundary);
}

struct Cluster
{
    Box3 box;
    int strokes = 0;
    std::vector<Vec3> points;
};

// Clusters of strokes that touch, numbered by their first stroke.
std::vector<int> clustersOf(const StrokeSet &strokes, double gap, std::vector<Cluster> &clusters)
{
    std::vector<Vec3> points;
    std::vector<int> strokeOf;
    for (std::size_t s = 0; s < strokes.strokes.size(); ++s)
        if (carriesSurface(strokes.strokes[s]))
            for (const Vec3 &p : resampled(strokes.strokes[s].points, step)) {
                points.push_back(p);
                strokeOf.push_back(int(s));
            }
    const PointTree tree(points);
    std::vector<int> root(strokes.strokes.size());
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&](int s) {
        while (root[std::size_t(s)] != s)
            s = root[std::size_t(s)] = root[std::size_t(root[std::size_t(s)])];
        return s;
    };
    for (std::size_t i = 0; i < points.size(); ++i)
        for (int j : tree.within(points[i], gap)) {
            const int a = find(strokeOf[i]), b = find(strokeOf[std::size_t(j)]);
            root[std::size_t(std::max(a, b))] = std::min(a, b);
        }
    std::vector<int> numberOf(root.size(), -1), clusterOf(root.size(), -1);
    for (std::size_t s = 0; s < root.size(); ++s) {
        if (!carriesSurface(strokes.strokes[s]))
            continue;
        int &number = numberOf[std::size_t(find(int(s)))];
        if (number < 0) {
            number = int(clusters.size());
            clusters.emplace_back();
        }
        clusterOf[s] = number;
        ++clusters[std::size_t(number)].strokes;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        Cluster &cluster = clusters[std::size_t(clusterOf[std::size_t(strokeOf[i])])];
        cluster.box.add(points[i]);
        cluster.points.push_back(points[i]);
    }
    return clusterOf;
}

double distanceBetween(const Cluster &a, const PointTree &b)
{
    double least = 1e300;
    for (const Vec3 &p : a.points)
        least = std::min(least, (b.points()[std::size_t(b.nearest(p, 1).front())] - p).norm());
    return least;
}

StrokeSet strokesOfBody(const StrokeSet &strokes, const std::vector<int> &bodies, int body)
{
    StrokeSet part = strokes;
    part.strokes.clear();
    for (std::size_t s = 0; s < bodies.size(); ++s)
        if (bodies[s] == body)
            part.strokes.push_back(strokes.strokes[s]);
    return part;
}

FlatEnd inInputFrame(FlatEnd end, const UnitFrame &frame)
{
    end.centre = frame.inputFromUnit(end.centre);
    for (Vec3 &p : end.inside)
        p = frame.inputFromUnit(p);
    end.spacing *= frame.diagonal;
    return end;
}

} // namespace

std::vector<int> bodiesOf(const StrokeSet &strokes, const PartOptions &options)
{
    std::vector<Cluster> clusters;
    std::vector<int> bodies = clustersOf(strokes, options.gap, clusters);
    std::vector<int> bodyOf(clusters.size(), -1);
    std::vector<PointTree> trees;
    for (std::size_t c = 0; c < clusters.size(); ++c)
        if (clusters[c].strokes >= options.fewestStrokes &&
            clusters[c].box.diagonal() >= options.leastExtent) {
            bodyOf[c] = int(trees.size());
            trees.emplace_back(clusters[c].points);
        }
    for (std::size_t c = 0; c < clusters.size(); ++c) {
        if (bodyOf[c] >= 0)
            continue;
        bodyOf[c] = 0;
        double nearest = 1e300;
        for (std::size_t b = 0; b < trees.size(); ++b)
            if (const double d = distanceBetween(clusters[c], trees[b]); d < nearest) {
                nearest = d;
                bodyOf[c] = int(b);
            }
    }
    for (int &body : bodies)
        if (body >= 0)
            body = bodyOf[std::size_t(body)];
    return bodies;
}

Result<Proxy> makePartProxy(const StrokeSet &strokes, const ProxyOptions &options, const PartOptions &parts,
                            const JobControl &control)
{
    const std::vector<int> bodies = bodiesOf(strokes, parts);
    const int count = bodies.empty() ? 0 : *std::max_element(bodies.begin(), bodies.end()) + 1;
    if (count < 2)
        return makeProxy(strokes, options, control);

    std::vector<StrokeSet> sets;
    std::vector<double> areas; // about, so that triangles are of one size everywhere
    double area = 0.0;
    for (int b = 0; b < count; ++b) {
        sets.push_back(strokesOfBody(strokes, bodies, b));
        const double diagonal = unitFrameOf(sets.back()).diagonal;
        areas.push_back(diagonal * diagonal);
        area += areas.back();
    }
    Proxy whole;
    double largest = 0.0;
    for (int b = 0; b < count; ++b) {
        const UnitFrame frame = unitFrameOf(sets[std::size_t(b)]);
        const double share = areas[std::size_t(b)] / area;
        ProxyOptions own = options;
        own.targetVertices = std::max(parts.fewestVertices, int(share * options.targetVertices));
        Result<Proxy> proxy = makeProxy(inUnitFrame(sets[std::size_t(b)], frame), own,
                                        control.part(double(b) / count, double(b + 1) / count));
        if (!proxy && proxy.error().isCancelled())
            return proxy;
        if (!proxy) { // flat, or too little of it: strokes are better followed loosely than lost
            Result<Proxy> together = makeProxy(strokes, options, control);
            if (together)
                together->remarks += (together->remarks.empty() ? "" : "; ") +
                                     std::string("one of its bodies alone gives none: ") +
                                     proxy.error().problem;
            return together;
        }
        const TriangleMesh mesh = inInputFrame(proxy->mesh, frame);
        const int first = whole.mesh.vertexCount();
        whole.mesh.vertices.insert(whole.mesh.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
        for (const Triangle &t : mesh.triangles)
            whole.mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
        for (FlatEnd &end : proxy->flatEnds)
            whole.flatEnds.push_back(inInputFrame(std::move(end), frame));
        whole.isOpen |= proxy->isOpen;
        if (!proxy->remarks.empty())
            whole.remarks += (whole.remarks.empty() ? "" : "; ") + proxy->remarks;
        if (share > largest) { // its kind speaks for all
            largest = share;
            whole.kind = proxy->kind;
            whole.alpha = proxy->alpha * frame.diagonal;
            whole.lambda = proxy->lambda;
        }
    }
    return whole;
}

} // namespace ductus
