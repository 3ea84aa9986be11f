#include "surfacing/refinement/scribble_effect.h"

#include "surfacing/refinement/region_cut.h"
#include "surfacing/segmentation/region_fit.h"

#include <algorithm>
#include <map>
#include <utility>

namespace ductus {

namespace {

// Against all other models on locked vertices: more than any energy there is, yet finite.
constexpr double lockCost = 1e3;
// Against other models next to a seam: a hundred times the whole simplicity term, so that a seam stays where
// it is.
constexpr double seamCost = 1.0;
// A split drawn this near to a stroke meant the stroke. Share of the box diagonal.
constexpr double snappingDistance = 0.04;
// What a scribble for a new region takes where no stroke says how far it goes. Share of the box diagonal.
constexpr double nearScribble = 0.04;

Error refusal(std::string problem, std::string remedy)
{
    return {ErrorCode::InvalidArgument, "Applying a scribble", std::move(problem), std::move(remedy), ""};
}

class EffectBuilder
{
public:
    EffectBuilder(const ScribbleDomain &domain, const LabelSolution &before, const Scribble &scribble,
                  const SegmentationOptions &options)
        : mDomain(domain), mScribble(scribble), mOptions(options),
          mPenalty(100.0 * options.epsilon * options.epsilon), // (10 epsilon)^2, Eq. III.13
          mEffect{before.fit, before.constraints, before.vertexIsLocked}
    {
    }

    Result<ScribbleEffect> build()
    {
        const Result<ScribblePath> path = layOnProxy(mDomain, mScribble.points);
        if (!path)
            return path.error();
        for (int v : path->vertices)
            if (!mEffect.vertexIsLocked[std::size_t(v)])
                mTouched.push_back(v);
        if (mTouched.empty())
            return refusal("it lies in a locked region", "Remove the lock first");
        switch (mScribble.kind) {
        case ScribbleKind::NewRegion:
            newRegion();
            break;
        case ScribbleKind::Merge:
            merge();
            break;
        case ScribbleKind::Lock:
            lock();
            break;
        case ScribbleKind::SetDegree:
            if (mScribble.degree < 1 || mScribble.degree > maxPolynomialDegree)
                return refusal("the degree is not one of 1 to 4",
                               "Give a degree from 1 (plane) to 4 (quartic)");
            setDegree();
            break;
        case ScribbleKind::ForbidSeam:
            forbidSeam();
            break;
        case ScribbleKind::Seam:
        case ScribbleKind::Split:
            if (!cutRegions(*path))
                return refusal("it does not part a region",
                               "Draw it from border to border of a region, or closed up to a ring");
            break;
        }
        return std::move(mEffect);
    }

private:
    std::vector<int> &labels() { return mEffect.start.labels; }
    int idAt(int vertex) { return mEffect.start.models[std::size_t(labels()[std::size_t(vertex)])].id; }

    // On a flat region the new model is the old one once more and would take all of it. So it gets the cells
    // between strokes it was drawn in and those it fits better; where no stroke divides the region, what lies
    // near the scribble.
    void newRegion()
    {
        const std::vector<std::vector<int>> parts = touchedParts();
        forget(mTouched);
        const int id = addModel(supportNear(mTouched), mTouched, mScribble.degree);
        want(mTouched, id, mPenalty);
        const std::vector<double> &costs = *mEffect.start.models.back().costs;
        for (const std::vector<int> &part : parts) {
            const std::vector<double> &old =
                *mEffect.start.models[std::size_t(labels()[std::size_t(part.front())])].costs;
            const std::vector<std::vector<int>> cells = cellsOf(part);
            if (cells.size() == 1 && !isBetter(part, costs, old)) {
                keepNear(part, id);
                continue;
            }
            for (const std::vector<int> &cell : cells)
                if (!isTouched(cell) && !isBetter(cell, costs, old))
                    for (int v : cell)
                        mEffect.constraints.preferences.push_back({v, id, false, mPenalty});
        }
    }

    // Vertices of \a part by the cells that strokes divide it into.
    std::vector<std::vector<int>> cellsOf(const std::vector<int> &part) const
    {
        std::vector<char> open(mDomain.association.pointsOfVertex.size(), 0);
        for (int v : part)
            open[std::size_t(v)] = 1;
        std::vector<std::vector<int>> cells;
        for (int start : part) {
            if (!std::exchange(open[std::size_t(start)], 0))
                continue;
            std::vector<int> cell{start};
            for (std::size_t next = 0; next < cell.size(); ++next)
                for (int e : mDomain.topology.vertexEdges[std::size_t(cell[next])]) {
                    const int w = mDomain.topology.neighbour(cell[next], e);
                    if (!mDomain.association.edgeIsCrossed[std::size_t(e)] &&
                        std::exchange(open[std::size_t(w)], 0))
                        cell.push_back(w);
                }
            cells.push_back(std::move(cell));
        }
        return cells;
    }

    bool isTouched(const std::vector<int> &vertices) const
    {
        return std::any_of(vertices.begin(), vertices.end(), [this](int v) {
            return std::find(mTouched.begin(), mTouched.end(), v) != mTouched.end();
        });
    }

    // By more than strokes tremble: a quarter of epsilon in the mean, and a fifth of what was off.
    bool isBetter(const std::vector<int> &vertices, const std::vector<double> &costs,
                  const std::vector<double> &old) const
    {
        double gain = 0.0, all = 0.0, pairs = 0.0;
        for (int v : vertices) {
            gain += old[std::size_t(v)] - costs[std::size_t(v)];
            all += old[std::size_t(v)];
            pairs += double(mDomain.association.pointsOfVertex[std::size_t(v)].size());
        }
        return gain > 0.2 * all && gain > pairs / (16.0 * std::max(mDomain.association.pairCount, 1));
    }

    void keepNear(const std::vector<int> &part, int id)
    {
        std::vector<int> near;
        for (int v : part) {
            double nearest = nearScribble;
            for (int w : mTouched)
                nearest = std::min(
                    nearest,
                    (mDomain.proxy.vertices[std::size_t(v)] - mDomain.proxy.vertices[std::size_t(w)]).norm());
            if (nearest < nearScribble)
                near.push_back(v);
            else
                mEffect.constraints.preferences.push_back({v, id, false, mPenalty});
        }
        want(near, id, mPenalty);
    }

    // The thesis asks for the new model under the scribble only; here the regions it touched are not to come
    // back anywhere in their parts, or slivers of them would stay between the strokes.
    void merge()
    {
        std::vector<int> vertices;
        std::map<int, std::vector<int>> partsOfId;
        for (const std::vector<int> &part : touchedParts()) {
            vertices.insert(vertices.end(), part.begin(), part.end());
            std::vector<int> &of = partsOfId[idAt(part.front())];
            of.insert(of.end(), part.begin(), part.end());
        }
        forget(vertices);
        const int id = addModel(supportOf(mDomain.association, vertices), vertices, mScribble.degree);
        want(mTouched, id, mPenalty);
        for (const auto &[old, part] : partsOfId)
            for (int v : vertices)
                mEffect.constraints.preferences.push_back({v, old, false, mPenalty});
        relabel(vertices, id);
    }

    // The locked part gets a copy of its model that nobody else may take: so it neither shrinks nor grows.
    void lock()
    {
        for (const std::vector<int> &part : touchedParts()) {
            forget(part);
            LabelModel copy = mEffect.start.models[std::size_t(labels()[std::size_t(part.front())])];
            copy.id = mEffect.start.nextId++;
            const int id = copy.id;
            mEffect.start.models.push_back(std::move(copy));
            mEffect.constraints.held.push_back({id, 0, true});
            relabel(part, id);
            want(part, id, lockCost);
            for (std::size_t v = 0; v < labels().size(); ++v)
                if (idAt(int(v)) != id)
                    mEffect.constraints.preferences.push_back({int(v), id, false, lockCost});
            for (int v : part)
                mEffect.vertexIsLocked[std::size_t(v)] = 1;
        }
    }

    void setDegree()
    {
        for (const std::vector<int> &part : touchedParts()) {
            forget(part);
            const int id = addModel(supportOf(mDomain.association, part), part, mScribble.degree);
            relabel(part, id);
            want(part, id,
                 mPenalty); // all of it: another degree is no reason to give parts of the region away
        }
    }

    // Regions the line parts by itself are cut; if there are none, the one it runs through longest, by a
    // longer line.
    bool cutRegions(const ScribblePath &path)
    {
        const std::vector<std::vector<int>> parts = touchedParts();
        bool done = false;
        for (const std::vector<int> &part : parts)
            if (const auto cut = cutAlong(mDomain, part, path, CutEnds::AsDrawn)) {
                applyCut(*cut);
                done = true;
            }
        if (done)
            return true;
        std::size_t longest = 0, most = 0;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            std::size_t touched = 0;
            for (int v : mTouched)
                touched += std::binary_search(parts[i].begin(), parts[i].end(), v);
            if (touched > most) {
                most = touched;
                longest = i;
            }
        }
        const auto cut = cutAlong(mDomain, parts[longest], path, CutEnds::Extended);
        if (cut)
            applyCut(*cut);
        return cut.has_value();
    }

    void applyCut(RegionCut cut)
    {
        const bool isSeam = mScribble.kind == ScribbleKind::Seam;
        if (!isSeam)
            snapToStrokes(mDomain, cut, snappingDistance);
        const int old = idAt(cut.left.front());
        forget(cut.left);
        forget(cut.right);
        const int left = addModel(supportOf(mDomain.association, cut.left), cut.left, mScribble.degree);
        const int right = addModel(supportOf(mDomain.association, cut.right), cut.right, mScribble.degree);
        relabel(cut.left, left);
        relabel(cut.right, right);
        for (const auto &[side, other] : {std::pair(&cut.left, right), std::pair(&cut.right, left)})
            for (int v : *side) {
                mEffect.constraints.preferences.push_back({v, old, false, mPenalty});
                mEffect.constraints.preferences.push_back({v, other, false, mPenalty});
            }
        if (!isSeam)
            return;
        want(cut.seamLeft, left, seamCost);
        want(cut.seamRight, right, seamCost);
        for (int e : cut.crossedEdges)
            overrideEdge(e, crossedWeight());
    }

    // No border next to the line; what it kept apart may become one surface if the strokes allow it.
    void forbidSeam()
    {
        std::vector<char> isNear(labels().size(), 0);
        for (int v : mTouched)
            isNear[std::size_t(v)] = 1;
        std::vector<int> strip = mTouched;
        for (int v : mTouched)
            for (int e : mDomain.topology.vertexEdges[std::size_t(v)]) {
                const int w = mDomain.topology.neighbour(v, e);
                if (!isNear[std::size_t(w)] && !mEffect.vertexIsLocked[std::size_t(w)]) {
                    isNear[std::size_t(w)] = 1;
                    strip.push_back(w);
                }
            }
        forget(strip);
        for (std::size_t e = 0; e < mDomain.topology.edges.size(); ++e) {
            const MeshEdge &edge = mDomain.topology.edges[e];
            if (isNear[std::size_t(edge.v0)] && isNear[std::size_t(edge.v1)] &&
                !mEffect.vertexIsLocked[std::size_t(edge.v0)] &&
                !mEffect.vertexIsLocked[std::size_t(edge.v1)])
                overrideEdge(int(e), uncutWeight());
        }
        mTouched = strip;
        std::vector<int> vertices;
        const std::vector<std::vector<int>> parts = touchedParts();
        for (const std::vector<int> &part : parts)
            vertices.insert(vertices.end(), part.begin(), part.end());
        if (parts.size() < 2)
            return; // there is no border; none will come
        relabel(vertices, addModel(supportOf(mDomain.association, vertices), vertices, 0));
    }

    void overrideEdge(int edge, double weight)
    {
        std::erase_if(mEffect.constraints.edges, [&](const EdgeOverride &o) { return o.edge == edge; });
        mEffect.constraints.edges.push_back({edge, weight});
    }

    double leastWeight() const
    {
        const std::vector<double> &w = mDomain.association.edgeWeights;
        return *std::min_element(w.begin(), w.end());
    }
    double crossedWeight() const { return leastWeight(); }
    double uncutWeight() const // one such edge outweighs all others together
    {
        double sum = 0.0;
        for (double w : mDomain.association.edgeWeights)
            sum += w;
        return sum;
    }

    // Connected parts of regions with a touched vertex, each sorted; without locked vertices.
    std::vector<std::vector<int>> touchedParts()
    {
        std::vector<char> seen = mEffect.vertexIsLocked;
        std::vector<std::vector<int>> parts;
        for (int start : mTouched) {
            if (seen[std::size_t(start)])
                continue;
            const int label = labels()[std::size_t(start)];
            std::vector<int> part{start};
            seen[std::size_t(start)] = 1;
            for (std::size_t next = 0; next < part.size(); ++next)
                for (int e : mDomain.topology.vertexEdges[std::size_t(part[next])]) {
                    const int w = mDomain.topology.neighbour(part[next], e);
                    if (!seen[std::size_t(w)] && labels()[std::size_t(w)] == label) {
                        seen[std::size_t(w)] = 1;
                        part.push_back(w);
                    }
                }
            std::sort(part.begin(), part.end());
            parts.push_back(std::move(part));
        }
        return parts;
    }

    // What earlier scribbles wanted of these vertices no longer holds.
    void forget(const std::vector<int> &vertices)
    {
        std::vector<char> gone(labels().size(), 0);
        for (int v : vertices)
            gone[std::size_t(v)] = 1;
        // The last word counts, except on locks.
        std::erase_if(mEffect.constraints.preferences, [&](const VertexPreference &p) {
            return gone[std::size_t(p.vertex)] && p.cost < lockCost;
        });
    }

    void want(const std::vector<int> &vertices, int id, double cost)
    {
        for (int v : vertices)
            mEffect.constraints.preferences.push_back({v, id, true, cost});
    }

    void relabel(const std::vector<int> &vertices, int id)
    {
        const int label = mEffect.start.labelOf(id);
        for (int v : vertices)
            labels()[std::size_t(v)] = label;
    }

    // Stroke points of the vertices; where a scribble runs between strokes, rings are added until there are
    // some.
    RegionSupport supportNear(const std::vector<int> &vertices) const
    {
        constexpr std::size_t enough = 12;
        std::vector<char> seen(mDomain.association.pointsOfVertex.size(), 0);
        std::vector<int> grown = vertices;
        for (int v : grown)
            seen[std::size_t(v)] = 1;
        std::size_t ringBegin = 0;
        for (int ring = 0; ring < 40; ++ring) {
            RegionSupport support = supportOf(mDomain.association, seen);
            if (support.points.size() >= enough)
                return support;
            const std::size_t ringEnd = grown.size();
            for (std::size_t i = ringBegin; i < ringEnd; ++i)
                for (int e : mDomain.topology.vertexEdges[std::size_t(grown[i])]) {
                    const int w = mDomain.topology.neighbour(grown[i], e);
                    if (!seen[std::size_t(w)]) {
                        seen[std::size_t(w)] = 1;
                        grown.push_back(w);
                    }
                }
            ringBegin = ringEnd;
        }
        return supportOf(mDomain.association, seen);
    }

    // A model fitted to the points, of the given degree or the one of least energy; its id.
    int addModel(const RegionSupport &support, const std::vector<int> &vertices, int degree)
    {
        const Association &a = mDomain.association;
        const int lowest = degree ? degree : 1, highest = degree ? degree : mOptions.maxDegree;
        const int id = mEffect.start.nextId++;
        std::optional<LabelModel> best;
        double bestEnergy = 0.0;
        for (int d = lowest; d <= highest; ++d) {
            LabelModel model = support.points.empty()
                                   ? mEffect.start.models[std::size_t(labels()[std::size_t(vertices[0])])]
                                   : labelModel(a, fitRegion(a, support, d, mOptions.fit), id, mOptions);
            model.id = id;
            double energy = labelCost(model.model, mOptions);
            for (int v : vertices)
                energy += (*model.costs)[std::size_t(v)];
            if (!best || energy < bestEnergy) {
                best = std::move(model);
                bestEnergy = energy;
            }
        }
        mEffect.start.models.push_back(std::move(*best));
        mEffect.constraints.held.push_back({id, degree, false});
        return id;
    }

    const ScribbleDomain &mDomain;
    const Scribble &mScribble;
    const SegmentationOptions &mOptions;
    const double mPenalty;
    ScribbleEffect mEffect;
    std::vector<int> mTouched; // scribbled vertices that are not locked
};

} // namespace

Result<ScribbleEffect> effectOf(const ScribbleDomain &domain, const LabelSolution &before,
                                const Scribble &scribble, const SegmentationOptions &options)
{
    return EffectBuilder(domain, before, scribble, options).build();
}

} // namespace ductus
