// The cut of surfacing-research.md section 5 [Boykov, Veksler, Zabih 2001; Delong et al. 2012], written so
// that every term is symmetric in its vertices. Source side = keep, sink side = take alpha; relative to "all
// keep":
//   gain_v   = D_v(l_v) - D_v(alpha) + sum_u w_uv/2 [l_u != l_v] + sum_{l_u = alpha} w_uv/2
//              arc v->sink of gain_v where positive (demand), arc source->v of -gain_v where negative
//              (supply);
//   edge u,v arcs both ways of w where the labels agree, of w/2 where they differ (the other half is in
//   gain); label b  node y_b with arc y_b->sink of h_b and arcs v->y_b of h_b for its vertices.
// The energy saved by the best expansion is (sum of demands) - (maximum flow), less h_alpha if alpha was
// unused.
//
// Two things keep a move local, both exact:
//  - A label's demand h_b is met beforehand out of the supply of its own vertices where that suffices (any
//    feasible flow may be the start of a maximum one), so that labels sure to stay never enter the graph.
//  - The graph holds the nodes with demand and grows by the neighbours of those that can still reach the
//  sink.
//    When none lacks a neighbour, the sink's side is closed in the whole graph and the flow is maximal there.
#include "numeric/expansion_move.h"

// The header-only form of libmaxflow: its library lacks 64-bit capacities.
#define MAXFLOW_INCLUDE_TEMPLATE_IMPLEMENTATION
#include <maxflow.h>
#undef MAXFLOW_INCLUDE_TEMPLATE_IMPLEMENTATION

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

using Capacity = std::int64_t;
using Graph = maxflow::Graph<Capacity, Capacity, Capacity>;

// The energy before the move becomes this many capacity units: rounding stays below 1e-15 of it an arc, and
// integers leave no residuals for the search to stall on.
constexpr double energyUnits = double(1LL << 50);

// No flow exceeds the energy before the move; an arc this wide is never cut.
constexpr Capacity widest = 1LL << 52;

} // namespace

struct ExpansionMove::Flow
{
    Graph graph;
    bool running = false; // search trees exist; changed nodes must be marked

    // All memory at once: the library moves its arrays when they overflow.
    Flow(int nodes, int arcs) : graph(nodes, arcs) {}

    void mark(int node)
    {
        if (running)
            graph.mark_node(node);
    }
};

ExpansionMove::ExpansionMove(const LabelingProblem &problem, std::vector<int> labels)
    : mProblem(problem), mLabels(std::move(labels))
{
    const std::size_t vertices = std::size_t(problem.vertexCount);
    const std::size_t labelCount = std::size_t(problem.labelCount());
    mKeepCost.resize(vertices);
    mBorder.resize(vertices);
    mMembers.resize(vertices);
    mGain.resize(vertices);
    mRouted.assign(vertices, 0);
    mTaken.assign(vertices, 0);
    mUnmet.assign(labelCount, 0);
    mNodeOfItem.assign(vertices + labelCount, -1);
    mFlow = std::make_unique<Flow>(int(vertices + labelCount), int(problem.edges.size() + vertices));
    buildAdjacency();
    mEnergy = labelingEnergy(problem, mLabels);
    refresh();
}

ExpansionMove::~ExpansionMove() = default;

void ExpansionMove::buildAdjacency()
{
    mFirstNeighbour.assign(std::size_t(mProblem.vertexCount) + 1, 0);
    for (const LabelingEdge &edge : mProblem.edges) {
        ++mFirstNeighbour[edge.u + 1];
        ++mFirstNeighbour[edge.v + 1];
    }
    for (int v = 0; v < mProblem.vertexCount; ++v)
        mFirstNeighbour[v + 1] += mFirstNeighbour[v];
    mNeighbours.resize(2 * mProblem.edges.size());
    mNeighbourWeights.resize(2 * mProblem.edges.size());
    std::vector<int> next(mFirstNeighbour.begin(), mFirstNeighbour.end() - 1);
    const auto add = [&](int from, int to, double weight) {
        mNeighbours[next[from]] = to;
        mNeighbourWeights[next[from]++] = weight;
    };
    for (const LabelingEdge &edge : mProblem.edges) {
        add(edge.u, edge.v, edge.weight);
        add(edge.v, edge.u, edge.weight);
    }
}

void ExpansionMove::refresh()
{
    mFirstMember.assign(std::size_t(mProblem.labelCount()) + 1, 0);
    for (int v = 0; v < mProblem.vertexCount; ++v) {
        const int label = mLabels[v];
        mKeepCost[v] = mProblem.dataCosts[label][v];
        ++mFirstMember[label + 1];
        double border = 0.0;
        for (int i = mFirstNeighbour[v]; i < mFirstNeighbour[v + 1]; ++i) {
            if (mLabels[mNeighbours[i]] != label)
                border += 0.5 * mNeighbourWeights[i];
        }
        mBorder[v] = border;
    }
    for (int label = 0; label < mProblem.labelCount(); ++label)
        mFirstMember[label + 1] += mFirstMember[label];
    std::vector<int> next(mFirstMember.begin(), mFirstMember.end() - 1);
    for (int v = 0; v < mProblem.vertexCount; ++v)
        mMembers[next[mLabels[v]]++] = v;
    mScale = energyUnits / std::max(mEnergy, 1e-280); // stays finite for tiny energies
}

Capacity ExpansionMove::toCapacity(double cost) const
{
    const double scaled = cost * mScale;
    if (!(scaled < double(widest)))
        return widest;
    return scaled > -double(widest) ? Capacity(std::llround(scaled)) : -widest;
}

ExpansionMove::Outcome ExpansionMove::expand(int alpha, double relativeTolerance, const JobControl &control)
{
    if (control.isCancelled())
        return Outcome::Cancelled;
    mAlpha = alpha;
    computeGains();
    routeLabelCosts();
    const Capacity demand = addDemandNodes();
    const bool alphaUnused = mFirstMember[alpha] == mFirstMember[alpha + 1];
    const Capacity price = alphaUnused ? toCapacity(mProblem.labelCosts[alpha]) : 0;

    Outcome outcome = Outcome::Unchanged;
    Capacity flow = 0;
    // The flow only grows, so demand - flow bounds what the move can still save.
    while (demand - flow > price) {
        if (control.isCancelled()) {
            outcome = Outcome::Cancelled;
            break;
        }
        flow = mFlow->graph.maxflow(mFlow->running);
        mFlow->running = true;
        if (demand - flow <= price)
            break;
        std::vector<int> growing;
        std::size_t kept = 0;
        for (int node : mUnexpanded) {
            if (mFlow->graph.what_segment(node) == Graph::SINK)
                growing.push_back(node);
            else
                mUnexpanded[kept++] = node;
        }
        mUnexpanded.resize(kept);
        if (growing.empty()) {
            if (accept(relativeTolerance))
                outcome = Outcome::Improved;
            break;
        }
        for (int node : growing)
            expandNode(node);
    }
    forgetNodes();
    if (outcome == Outcome::Improved)
        refresh();
    return outcome;
}

void ExpansionMove::computeGains()
{
    const std::span<const double> takeCost = mProblem.dataCosts[mAlpha];
    for (int v = 0; v < mProblem.vertexCount; ++v)
        mGain[v] = mKeepCost[v] - takeCost[v] + mBorder[v];
    for (int m = mFirstMember[mAlpha]; m < mFirstMember[mAlpha + 1]; ++m) {
        const int v = mMembers[m];
        for (int i = mFirstNeighbour[v]; i < mFirstNeighbour[v + 1]; ++i)
            mGain[mNeighbours[i]] += 0.5 * mNeighbourWeights[i]; // alpha's own vertices gain too, unread
    }
}

void ExpansionMove::routeLabelCosts()
{
    for (int label = 0; label < mProblem.labelCount(); ++label) {
        mUnmet[label] = 0;
        const int begin = mFirstMember[label];
        const int end = mFirstMember[label + 1];
        if (label == mAlpha || begin == end)
            continue;
        Capacity unmet = toCapacity(mProblem.labelCosts[label]);
        const auto route = [&](int v) {
            const Capacity amount = std::min(unmet, -demandOf(v));
            if (amount <= 0)
                return;
            mRouted[v] += amount;
            mRoutedVertices.push_back(v);
            unmet -= amount;
        };
        // The strongest vertex first: one with supply to spare does not pull its region into the graph.
        int strongest = mMembers[begin];
        for (int m = begin; m < end && unmet > 0; ++m) {
            if (mGain[mMembers[m]] < mGain[strongest])
                strongest = mMembers[m];
        }
        route(strongest);
        for (int m = begin; m < end && unmet > 0; ++m)
            route(mMembers[m]);
        mUnmet[label] = unmet;
    }
}

Capacity ExpansionMove::addDemandNodes()
{
    Capacity demand = 0;
    for (int v = 0; v < mProblem.vertexCount; ++v) {
        if (mGain[v] > 0.0 && mLabels[v] != mAlpha) {
            const Capacity own = demandOf(v);
            if (own > 0) {
                addVertexNode(v);
                demand += own;
            }
        }
    }
    for (int label = 0; label < mProblem.labelCount(); ++label) {
        if (mUnmet[label] > 0) {
            addLabelNode(label);
            demand += mUnmet[label];
        }
    }
    return demand;
}

void ExpansionMove::addVertexNode(int vertex)
{
    Graph &graph = mFlow->graph;
    const int node = graph.add_node();
    mNodeOfItem[vertex] = node;
    mItemOfNode.push_back(vertex);
    mUnexpanded.push_back(node);
    const Capacity demand = demandOf(vertex);
    graph.add_tweights(node, std::max<Capacity>(0, -demand), std::max<Capacity>(0, demand));
    for (int i = mFirstNeighbour[vertex]; i < mFirstNeighbour[vertex + 1]; ++i) {
        const int other = mNeighbours[i];
        if (mNodeOfItem[other] < 0 || mNeighbourWeights[i] == 0.0)
            continue;
        const bool same = mLabels[other] == mLabels[vertex];
        const Capacity width = toCapacity((same ? 1.0 : 0.5) * mNeighbourWeights[i]);
        graph.add_edge(node, mNodeOfItem[other], width, width);
        mFlow->mark(mNodeOfItem[other]);
    }
    const int label = mLabels[vertex];
    const int labelNode = mNodeOfItem[mProblem.vertexCount + label];
    if (labelNode >= 0) {
        const Capacity width = toCapacity(mProblem.labelCosts[label]);
        graph.add_edge(node, labelNode, width - mRouted[vertex], mRouted[vertex]);
        mFlow->mark(labelNode);
    }
    mFlow->mark(node);
}

void ExpansionMove::addLabelNode(int label)
{
    Graph &graph = mFlow->graph;
    const int node = graph.add_node();
    mNodeOfItem[mProblem.vertexCount + label] = node;
    mItemOfNode.push_back(mProblem.vertexCount + label);
    mUnexpanded.push_back(node);
    graph.add_tweights(node, 0, mUnmet[label]);
    const Capacity width = toCapacity(mProblem.labelCosts[label]);
    for (int m = mFirstMember[label]; m < mFirstMember[label + 1]; ++m) {
        const int vertex = mMembers[m];
        if (mNodeOfItem[vertex] < 0)
            continue;
        graph.add_edge(mNodeOfItem[vertex], node, width - mRouted[vertex], mRouted[vertex]);
        mFlow->mark(mNodeOfItem[vertex]);
    }
    mFlow->mark(node);
}

// Adds every node with a residual arc into this one; alpha's vertices are no nodes.
void ExpansionMove::expandNode(int node)
{
    const int item = mItemOfNode[node];
    if (item >= mProblem.vertexCount) {
        const int label = item - mProblem.vertexCount;
        for (int m = mFirstMember[label]; m < mFirstMember[label + 1]; ++m) {
            if (mNodeOfItem[mMembers[m]] < 0)
                addVertexNode(mMembers[m]);
        }
        return;
    }
    for (int i = mFirstNeighbour[item]; i < mFirstNeighbour[item + 1]; ++i) {
        const int other = mNeighbours[i];
        if (mNodeOfItem[other] < 0 && mNeighbourWeights[i] > 0.0 && mLabels[other] != mAlpha)
            addVertexNode(other);
    }
    const int labelItem = mProblem.vertexCount + mLabels[item];
    if (mRouted[item] > 0 && mNodeOfItem[labelItem] < 0)
        addLabelNode(mLabels[item]);
}

double ExpansionMove::changeOfEnergy() const
{
    double change = 0.0;
    std::vector<int> leaving(std::size_t(mProblem.labelCount()), 0);
    for (int v : mTakers) {
        change += mProblem.dataCosts[mAlpha][v] - mKeepCost[v];
        ++leaving[mLabels[v]];
        for (int i = mFirstNeighbour[v]; i < mFirstNeighbour[v + 1]; ++i) {
            const int other = mNeighbours[i];
            const double share = mTaken[other] ? 0.5 : 1.0; // an edge inside the set is met twice
            const bool cutBefore = mLabels[other] != mLabels[v];
            const bool cutAfter = !mTaken[other] && mLabels[other] != mAlpha;
            change += share * mNeighbourWeights[i] * (double(cutAfter) - double(cutBefore));
        }
    }
    for (int label = 0; label < mProblem.labelCount(); ++label) {
        const int members = mFirstMember[label + 1] - mFirstMember[label];
        if (leaving[label] > 0 && leaving[label] == members)
            change -= mProblem.labelCosts[label];
    }
    if (mFirstMember[mAlpha] == mFirstMember[mAlpha + 1])
        change += mProblem.labelCosts[mAlpha];
    return change;
}

// Takes the sink's side over, unless the true energy says that it does not pay.
bool ExpansionMove::accept(double relativeTolerance)
{
    mTakers.clear();
    for (int node = 0; node < int(mItemOfNode.size()); ++node) {
        if (mItemOfNode[node] < mProblem.vertexCount && mFlow->graph.what_segment(node) == Graph::SINK) {
            mTakers.push_back(mItemOfNode[node]);
            mTaken[mItemOfNode[node]] = 1;
        }
    }
    // The change is cheap and weeds out most failures; the verdict is the energy itself.
    const double largest = mEnergy - relativeTolerance * mEnergy;
    bool accepted = false;
    if (!mTakers.empty() && changeOfEnergy() < 0.0) {
        std::vector<int> labels = mLabels;
        for (int v : mTakers)
            labels[v] = mAlpha;
        const double energy = labelingEnergy(mProblem, labels);
        if (energy < largest) {
            mLabels = std::move(labels);
            mEnergy = energy;
            accepted = true;
        }
    }
    for (int v : mTakers)
        mTaken[v] = 0;
    return accepted;
}

void ExpansionMove::forgetNodes()
{
    for (int item : mItemOfNode)
        mNodeOfItem[item] = -1;
    mItemOfNode.clear();
    mUnexpanded.clear();
    for (int v : mRoutedVertices)
        mRouted[v] = 0;
    mRoutedVertices.clear();
    mFlow->graph.reset();
    mFlow->running = false;
}

} // namespace ductus
