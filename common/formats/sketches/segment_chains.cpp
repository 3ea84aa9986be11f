#include "formats/sketches/segment_chains.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ductus {

namespace {

// An end of segment s: 2 s for its first vertex, 2 s + 1 for its second.
using End = int;
constexpr End none = -1;

End otherEnd(End end)
{
    return end ^ 1;
}

class Chainer
{
public:
    Chainer(const std::vector<Segment> &segments, const std::vector<Vec3> &vertices);
    std::vector<std::vector<int>> chains();

private:
    int vertexOf(End end) const { return mSegments[std::size_t(end / 2)][std::size_t(end % 2)]; }
    Vec3 directionInto(End end) const;
    void pairStraightEnds(const End *ends, int count);
    std::vector<End> walkFrom(End start) const;
    std::vector<int> oriented(std::vector<End> steps, bool closed) const;

    const std::vector<Segment> &mSegments;
    const std::vector<Vec3> &mVertices;
    std::vector<End> mPartner; // the end the stroke goes on with, or none
};

Chainer::Chainer(const std::vector<Segment> &segments, const std::vector<Vec3> &vertices)
    : mSegments(segments), mVertices(vertices), mPartner(2 * segments.size(), none)
{
    std::vector<End> byVertex(2 * segments.size());
    std::iota(byVertex.begin(), byVertex.end(), 0);
    std::stable_sort(byVertex.begin(), byVertex.end(),
                     [&](End a, End b) { return vertexOf(a) < vertexOf(b); });
    for (std::size_t begin = 0; begin < byVertex.size();) {
        std::size_t end = begin + 1;
        while (end < byVertex.size() && vertexOf(byVertex[end]) == vertexOf(byVertex[begin]))
            ++end;
        const int degree = int(end - begin);
        if (degree == 2) {
            mPartner[std::size_t(byVertex[begin])] = byVertex[begin + 1];
            mPartner[std::size_t(byVertex[begin + 1])] = byVertex[begin];
        } else if (degree == 3 || degree == 4) {
            pairStraightEnds(&byVertex[begin], degree);
        }
        begin = end;
    }
}

/// Unit direction in which the segment arrives at \a end; zero without length.
Vec3 Chainer::directionInto(End end) const
{
    const Vec3 step = mVertices[std::size_t(vertexOf(end))] - mVertices[std::size_t(vertexOf(otherEnd(end)))];
    const double length = step.norm();
    return length > 0.0 ? Vec3(step / length) : Vec3(Vec3::Zero());
}

void Chainer::pairStraightEnds(const End *ends, int count)
{
    struct Candidate
    {
        double cosine;
        End a, b;
    };
    std::vector<Candidate> candidates;
    const double straightCosine = std::sqrt(3.0) / 2.0; // 30 degrees
    for (int i = 0; i < count; ++i)
        for (int j = i + 1; j < count; ++j) {
            const double cosine = -directionInto(ends[i]).dot(directionInto(ends[j]));
            if (cosine > straightCosine)
                candidates.push_back({cosine, ends[i], ends[j]});
        }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate &x, const Candidate &y) { return x.cosine > y.cosine; });
    for (const Candidate &c : candidates)
        if (mPartner[std::size_t(c.a)] == none && mPartner[std::size_t(c.b)] == none) {
            mPartner[std::size_t(c.a)] = c.b;
            mPartner[std::size_t(c.b)] = c.a;
        }
}

/// The ends at which the chain enters its segments, beginning with \a start, until it stops or closes.
std::vector<End> Chainer::walkFrom(End start) const
{
    std::vector<End> steps;
    for (End end = start; end != none; end = mPartner[std::size_t(otherEnd(end))]) {
        steps.push_back(end);
        if (mPartner[std::size_t(otherEnd(end))] == start)
            break;
    }
    return steps;
}

std::vector<int> Chainer::oriented(std::vector<End> steps, bool closed) const
{
    // Entering a segment at its second vertex means walking against it.
    const auto first =
        std::min_element(steps.begin(), steps.end(), [](End a, End b) { return a / 2 < b / 2; });
    bool againstFirst = *first % 2 == 1;
    std::ptrdiff_t balance = 0;
    for (std::size_t i = 1; i < steps.size(); ++i)
        balance += steps[i] / 2 > steps[i - 1] / 2 ? 1 : -1;
    const bool reverse = balance != 0 ? balance < 0 : againstFirst;
    if (reverse) {
        std::reverse(steps.begin(), steps.end());
        for (End &end : steps)
            end = otherEnd(end);
    }
    if (closed)
        std::rotate(steps.begin(),
                    std::min_element(steps.begin(), steps.end(), [](End a, End b) { return a / 2 < b / 2; }),
                    steps.end());
    std::vector<int> chain;
    chain.reserve(steps.size() + 1);
    for (End end : steps)
        chain.push_back(vertexOf(end));
    chain.push_back(vertexOf(otherEnd(steps.back())));
    return chain;
}

std::vector<std::vector<int>> Chainer::chains()
{
    std::vector<std::vector<int>> result;
    std::vector<char> used(mSegments.size(), 0);
    for (std::size_t s = 0; s < mSegments.size(); ++s) {
        if (used[s])
            continue;
        // Forwards from here tells whether the chain closes; if not, its last end reversed is where it
        // starts.
        std::vector<End> steps = walkFrom(End(2 * s));
        const bool closed = mPartner[std::size_t(otherEnd(steps.back()))] == steps.front();
        if (!closed)
            steps = walkFrom(otherEnd(steps.back()));
        for (End end : steps)
            used[std::size_t(end / 2)] = 1;
        result.push_back(oriented(std::move(steps), closed));
    }
    return result;
}

} // namespace

std::vector<std::vector<int>> chainSegments(const std::vector<Segment> &segments,
                                            const std::vector<Vec3> &vertices)
{
    return Chainer(segments, vertices).chains();
}

} // namespace ductus
