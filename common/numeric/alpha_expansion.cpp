#include "numeric/alpha_expansion.h"

#include "numeric/expansion_move.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace ductus {

namespace {

constexpr const char *attempted = "Choosing a label for every vertex";

// Neumaier's sum: the acceptance of moves compares energies to 1e-12.
class ExactSum
{
public:
    void add(double term)
    {
        const double sum = mSum + term;
        mRest += std::abs(mSum) >= std::abs(term) ? (mSum - sum) + term : (term - sum) + mSum;
        mSum = sum;
    }
    double value() const { return mSum + mRest; }

private:
    double mSum = 0.0;
    double mRest = 0.0;
};

Error malformed(std::string problem)
{
    return {ErrorCode::InvalidArgument, attempted, std::move(problem), "", ""};
}

bool isCost(double value)
{
    return value >= 0.0 && std::isfinite(value);
}

Result<void> checkEdges(const LabelingProblem &problem)
{
    const int vertices = problem.vertexCount;
    double total = 0.0;
    std::vector<std::pair<int, int>> pairs;
    pairs.reserve(problem.edges.size());
    for (const LabelingEdge &edge : problem.edges) {
        if (edge.u < 0 || edge.u >= vertices || edge.v < 0 || edge.v >= vertices)
            return malformed("an edge names a vertex that does not exist");
        if (edge.u == edge.v)
            return malformed("an edge joins vertex " + std::to_string(edge.u) + " to itself");
        if (!isCost(edge.weight))
            return malformed("an edge's weight is negative or not finite");
        total += edge.weight;
        pairs.emplace_back(std::minmax(edge.u, edge.v));
    }
    if (!std::isfinite(total))
        return malformed("the edges' weights are too large to add up");
    std::sort(pairs.begin(), pairs.end());
    if (std::adjacent_find(pairs.begin(), pairs.end()) != pairs.end())
        return malformed("two edges join the same vertices");
    return {};
}

Result<void> check(const LabelingProblem &problem, const AlphaExpansionOptions &options,
                   const std::vector<int> &initial)
{
    if (problem.vertexCount < 0)
        return malformed("the number of vertices is negative");
    if (problem.vertexCount > 0 && problem.dataCosts.empty())
        return malformed("there is no label to choose from");
    if (problem.labelCosts.size() != problem.dataCosts.size())
        return malformed("there must be one label cost for each label");
    for (const std::span<const double> &column : problem.dataCosts) {
        if (column.size() != std::size_t(problem.vertexCount))
            return malformed("a label's data costs do not number the vertices");
        if (!std::all_of(column.begin(), column.end(), isCost))
            return malformed("a data cost is negative or not finite");
    }
    if (!std::all_of(problem.labelCosts.begin(), problem.labelCosts.end(), isCost))
        return malformed("a label cost is negative or not finite");
    if (!initial.empty() && initial.size() != std::size_t(problem.vertexCount))
        return malformed("the initial labels do not number the vertices");
    for (int label : initial) {
        if (label < 0 || label >= problem.labelCount())
            return malformed("an initial label does not exist");
    }
    if (options.maxCycles < 0 || !isCost(options.relativeTolerance))
        return malformed("the number of cycles or the tolerance is negative");
    return checkEdges(problem);
}

int bestSingleLabel(const LabelingProblem &problem)
{
    int best = 0;
    double lowest = INFINITY;
    for (int label = 0; label < problem.labelCount(); ++label) {
        ExactSum sum;
        sum.add(problem.labelCosts[label]);
        for (double cost : problem.dataCosts[label])
            sum.add(cost);
        if (sum.value() < lowest) {
            lowest = sum.value();
            best = label;
        }
    }
    return best;
}

} // namespace

double labelingEnergy(const LabelingProblem &problem, const std::vector<int> &labels)
{
    ExactSum sum;
    std::vector<char> used(problem.dataCosts.size(), 0);
    for (int v = 0; v < problem.vertexCount; ++v) {
        sum.add(problem.dataCosts[labels[v]][v]);
        used[labels[v]] = 1;
    }
    for (const LabelingEdge &edge : problem.edges) {
        if (labels[edge.u] != labels[edge.v])
            sum.add(edge.weight);
    }
    for (int label = 0; label < problem.labelCount(); ++label) {
        if (used[label])
            sum.add(problem.labelCosts[label]);
    }
    return sum.value();
}

Result<Labeling> alphaExpansion(const LabelingProblem &problem, const AlphaExpansionOptions &options,
                                const std::vector<int> &initial, const JobControl &control)
{
    if (const Result<void> checked = check(problem, options, initial); !checked)
        return checked.error();
    if (control.isCancelled())
        return cancelledError(attempted);
    if (problem.vertexCount == 0)
        return Labeling();

    std::vector<int> start = initial;
    if (start.empty())
        start.assign(std::size_t(problem.vertexCount), bestSingleLabel(problem));
    ExpansionMove move(problem, std::move(start));
    if (!std::isfinite(move.energy()))
        return malformed("the costs are too large to add up");

    // A label tried since the last change cannot succeed now: its best expansion is still the empty one (or,
    // when it was the one that changed, expanding it again finds the same set).
    const int labels = problem.labelCount();
    int changes = 0;
    std::vector<int> changesWhenTried(std::size_t(labels), -1);
    int cycle = 0;
    for (bool changed = true; changed && cycle < options.maxCycles; ++cycle) {
        changed = false;
        for (int alpha = 0; alpha < labels; ++alpha) {
            if (changesWhenTried[alpha] == changes)
                continue;
            // The number of cycles is unknown beforehand: each takes half of what is left.
            control.progress(1.0 - std::exp2(-(cycle + double(alpha) / labels)), attempted);
            const ExpansionMove::Outcome outcome = move.expand(alpha, options.relativeTolerance, control);
            if (outcome == ExpansionMove::Outcome::Cancelled)
                return cancelledError(attempted);
            if (outcome == ExpansionMove::Outcome::Improved) {
                ++changes;
                changed = true;
            }
            changesWhenTried[alpha] = changes;
        }
    }
    control.progress(1.0, attempted);
    return Labeling{move.labels(), move.energy(), cycle};
}

} // namespace ductus
