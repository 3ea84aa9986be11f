#include "surfacing/refinement/stroke_effect.h"

#include "base/parallel.h"
#include "surfacing/refinement/region_cut.h"
#include "surfacing/segmentation/region_fit.h"

#include <algorithm>
#include <set>

namespace ductus {

namespace {

constexpr int ringsAround = 3;                 // of proxy edges: which regions a stroke touches
constexpr double localReaches[] = {0.08, 0.2}; // of fits beside a new stroke, share of the box diagonal
constexpr int highestLocalDegree = 2;          // few points tell no more
constexpr std::size_t fewestPoints = 6;        // to fit anything to

struct Proposal
{
    RegionSupport support;
    int degree = 1;
};

class StrokeEffectBuilder
{
public:
    StrokeEffectBuilder(const ScribbleDomain &domain, const LabelSolution &before,
                        const SegmentationOptions &options)
        : mDomain(domain), mOptions(options), mFit(before.fit), mConstraints(before.constraints),
          mIsLocked(before.vertexIsLocked)
    {
        // The same models have other costs at other stroke points.
        parallelFor(0, mFit.models.size(), [&](std::size_t a) {
            LabelModel &model = mFit.models[a];
            model = labelModel(domain.association, std::move(model.model), model.id, options);
        });
    }

    StrokeEffect build(const StrokeDifference &difference)
    {
        const std::vector<ScribblePath> added = laid(difference.added), removed = laid(difference.removed);
        std::set<int> touched;
        for (const std::vector<ScribblePath> *paths : {&added, &removed})
            for (const ScribblePath &path : *paths)
                touched.merge(labelsAt(around(path.vertices)));
        refit(touched);
        for (const ScribblePath &path : removed)
            proposeUnions(labelsAt(around(path.vertices)));
        for (const ScribblePath &path : added)
            for (const std::vector<int> &part : partsAt(path.vertices))
                proposeSides(part, path);
        addProposals();

        StrokeEffect effect{{mFit, mConstraints, mIsLocked}, std::nullopt};
        for (const ScribblePath &path : added)
            divideAlong(path);
        if (mIsDivided)
            effect.divided = {std::move(mFit), mConstraints, mIsLocked};
        return effect;
    }

private:
    // Strokes that do not run near the proxy ask for nothing.
    std::vector<ScribblePath> laid(const std::vector<Stroke> &strokes) const
    {
        std::vector<ScribblePath> paths;
        for (const Stroke &stroke : strokes)
            if (Result<ScribblePath> path = layOnProxy(mDomain, stroke.points); path.ok())
                paths.push_back(std::move(*path));
        return paths;
    }

    std::vector<int> around(std::vector<int> vertices) const
    {
        std::vector<char> seen(mIsLocked.size(), 0);
        for (int v : vertices)
            seen[std::size_t(v)] = 1;
        std::size_t begin = 0;
        for (int ring = 0; ring < ringsAround; ++ring) {
            const std::size_t end = vertices.size();
            for (; begin < end; ++begin)
                for (int e : mDomain.topology.vertexEdges[std::size_t(vertices[begin])]) {
                    const int w = mDomain.topology.neighbour(vertices[begin], e);
                    if (!seen[std::size_t(w)]) {
                        seen[std::size_t(w)] = 1;
                        vertices.push_back(w);
                    }
                }
        }
        return vertices;
    }

    std::set<int> labelsAt(const std::vector<int> &vertices)
    {
        std::set<int> result;
        for (int v : vertices)
            if (!mIsLocked[std::size_t(v)])
                result.insert(mFit.labels[std::size_t(v)]);
        return result;
    }

    std::vector<char> flagsOfLabel(int label)
    {
        std::vector<char> flags(mFit.labels.size());
        for (std::size_t v = 0; v < flags.size(); ++v)
            flags[v] = mFit.labels[v] == label;
        return flags;
    }

    double energyOf(const LabelModel &model, const std::vector<int> &vertices) const
    {
        double energy = labelCost(model.model, mOptions);
        for (int v : vertices)
            energy += (*model.costs)[std::size_t(v)];
        return energy;
    }

    // A model at its old degree takes the place of the old one where it explains the region better; the other
    // degrees are offered.
    void refit(const std::set<int> &touched)
    {
        for (int label : touched) {
            LabelModel &old = mFit.models[std::size_t(label)];
            const HeldModel *held = mConstraints.heldModel(old.id);
            if (held && held->isFrozen)
                continue;
            const std::vector<char> flags = flagsOfLabel(label);
            const RegionSupport support = supportOf(mDomain.association, flags);
            if (support.points.size() < fewestPoints)
                continue;
            LabelModel again = labelModel(
                mDomain.association, fitRegion(mDomain.association, support, old.model.degree, mOptions.fit),
                old.id, mOptions);
            std::vector<int> vertices;
            for (std::size_t v = 0; v < flags.size(); ++v)
                if (flags[v])
                    vertices.push_back(int(v));
            const int degree = old.model.degree;
            if (energyOf(again, vertices) < energyOf(old, vertices))
                old = std::move(again);
            for (int d = 1; d <= mOptions.maxDegree && !held; ++d)
                if (d != degree)
                    mProposals.push_back({support, d});
        }
    }

    // Neighbours that met at a stroke that is no more.
    void proposeUnions(const std::set<int> &near)
    {
        std::set<std::pair<int, int>> pairs;
        for (const MeshEdge &edge : mDomain.topology.edges) {
            const int a = mFit.labels[std::size_t(edge.v0)], b = mFit.labels[std::size_t(edge.v1)];
            if (a != b && near.count(a) && near.count(b))
                pairs.insert(std::minmax(a, b));
        }
        for (const auto &[a, b] : pairs) {
            const RegionSupport support = united(supportOf(mDomain.association, flagsOfLabel(a)),
                                                 supportOf(mDomain.association, flagsOfLabel(b)));
            propose(support, mOptions.maxDegree);
        }
    }

    // Connected parts of regions with a vertex of the path, each sorted; without locked vertices.
    std::vector<std::vector<int>> partsAt(const std::vector<int> &vertices)
    {
        std::vector<char> seen = mIsLocked;
        std::vector<std::vector<int>> parts;
        for (int start : vertices) {
            if (seen[std::size_t(start)])
                continue;
            const int label = mFit.labels[std::size_t(start)];
            std::vector<int> part{start};
            seen[std::size_t(start)] = 1;
            for (std::size_t next = 0; next < part.size(); ++next)
                for (int e : mDomain.topology.vertexEdges[std::size_t(part[next])]) {
                    const int w = mDomain.topology.neighbour(part[next], e);
                    if (!seen[std::size_t(w)] && mFit.labels[std::size_t(w)] == label) {
                        seen[std::size_t(w)] = 1;
                        part.push_back(w);
                    }
                }
            std::sort(part.begin(), part.end());
            parts.push_back(std::move(part));
        }
        return parts;
    }

    void propose(const RegionSupport &support, int highestDegree)
    {
        if (support.points.size() < fewestPoints)
            return;
        for (int degree = 1; degree <= std::min(highestDegree, mOptions.maxDegree); ++degree)
            mProposals.push_back({support, degree});
    }

    // Fits to either side of the stroke: all of the part, if the stroke divides it, and what lies near the
    // stroke.
    void proposeSides(const std::vector<int> &part, const ScribblePath &path)
    {
        const std::optional<RegionCut> cut = cutAlong(mDomain, part, path, CutEnds::Extended);
        if (cut) {
            propose(supportOf(mDomain.association, cut->left), mOptions.maxDegree);
            propose(supportOf(mDomain.association, cut->right), mOptions.maxDegree);
        }
        for (double reach : localReaches)
            for (const std::vector<int> *side : {&path.left, &path.right})
                propose(supportOf(mDomain.association, beside(*side, part, path.crossedEdges, reach)),
                        highestLocalDegree);
    }

    // Vertices of the part within \a reach of those given, reached without crossing the stroke.
    std::vector<int> beside(const std::vector<int> &side, const std::vector<int> &part,
                            const std::vector<int> &crossedEdges, double reach) const
    {
        std::vector<char> isOpen(mIsLocked.size(), 0);
        for (int v : part)
            isOpen[std::size_t(v)] = 1;
        const std::set<int> crossed(crossedEdges.begin(), crossedEdges.end());
        std::vector<int> found;
        const auto reachVertex = [&](int v) {
            if (isOpen[std::size_t(v)])
                found.push_back(v);
            isOpen[std::size_t(v)] = 0;
        };
        for (int v : side)
            reachVertex(v);
        const int rings = int(reach / meanEdgeLength(mDomain.proxy));
        std::size_t begin = 0;
        for (int ring = 0; ring < rings; ++ring) {
            const std::size_t end = found.size();
            for (; begin < end; ++begin)
                for (int e : mDomain.topology.vertexEdges[std::size_t(found[begin])])
                    if (!crossed.count(e))
                        reachVertex(mDomain.topology.neighbour(found[begin], e));
        }
        return found;
    }

    void addProposals()
    {
        const std::size_t first = mFit.models.size();
        mFit.models.resize(first + mProposals.size());
        parallelFor(0, mProposals.size(), [&](std::size_t i) {
            mFit.models[first + i] = labelModel(
                mDomain.association,
                fitRegion(mDomain.association, mProposals[i].support, mProposals[i].degree, mOptions.fit),
                mFit.nextId + int(i), mOptions);
        });
        mFit.nextId += int(mProposals.size());
    }

    void divideAlong(const ScribblePath &path)
    {
        for (const std::vector<int> &part : partsAt(path.vertices)) {
            const std::optional<RegionCut> cut = cutAlong(mDomain, part, path, CutEnds::Extended);
            if (!cut)
                continue;
            const std::optional<int> left = bestModelFor(cut->left), right = bestModelFor(cut->right);
            if (!left || !right)
                continue;
            for (int v : cut->left)
                mFit.labels[std::size_t(v)] = *left;
            for (int v : cut->right)
                mFit.labels[std::size_t(v)] = *right;
            mIsDivided = true;
        }
    }

    // A new model of the degree of least energy; its label.
    std::optional<int> bestModelFor(const std::vector<int> &vertices)
    {
        const RegionSupport support = supportOf(mDomain.association, vertices);
        if (support.points.size() < fewestPoints)
            return std::nullopt;
        std::optional<LabelModel> best;
        for (int degree = 1; degree <= mOptions.maxDegree; ++degree) {
            LabelModel model =
                labelModel(mDomain.association, fitRegion(mDomain.association, support, degree, mOptions.fit),
                           mFit.nextId, mOptions);
            if (!best || energyOf(model, vertices) < energyOf(*best, vertices))
                best = std::move(model);
        }
        ++mFit.nextId;
        mFit.models.push_back(std::move(*best));
        return int(mFit.models.size()) - 1;
    }

    const ScribbleDomain &mDomain;
    const SegmentationOptions &mOptions;
    ModelLabeling mFit;
    const LabelConstraints &mConstraints;
    const std::vector<char> &mIsLocked;
    std::vector<Proposal> mProposals;
    bool mIsDivided = false;
};

} // namespace

StrokeEffect effectOf(const ScribbleDomain &domain, const LabelSolution &before,
                      const StrokeDifference &difference, const SegmentationOptions &options)
{
    return StrokeEffectBuilder(domain, before, options).build(difference);
}

} // namespace ductus
