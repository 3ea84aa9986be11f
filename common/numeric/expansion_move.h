// One alpha-expansion: the best set of vertices to hand over to label alpha, found as a minimum cut that
// grows only as far as the sink's side reaches. State between moves (labels, energy, adjacency) lives here;
// alpha_expansion.cpp decides which label comes next.
#pragma once

#include "base/job_control.h"
#include "numeric/alpha_expansion.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace ductus {

class ExpansionMove
{
public:
    enum class Outcome { Unchanged, Improved, Cancelled };

    /// \a problem must be valid (alpha_expansion.cpp checks) and outlive the object.
    ExpansionMove(const LabelingProblem &problem, std::vector<int> labels);
    ~ExpansionMove();

    /// Applies the best expansion on \a alpha if it lowers the energy, recomputed by definition, by more than
    /// the share \a relativeTolerance. Unchanged and Cancelled leave labels and energy as they were.
    Outcome expand(int alpha, double relativeTolerance, const JobControl &control);

    const std::vector<int> &labels() const { return mLabels; }
    double energy() const { return mEnergy; }

private:
    struct Flow;

    void buildAdjacency();
    void refresh();
    void computeGains();
    void routeLabelCosts();
    std::int64_t addDemandNodes();
    void addVertexNode(int vertex);
    void addLabelNode(int label);
    void expandNode(int node);
    void forgetNodes();
    bool accept(double relativeTolerance);
    double changeOfEnergy() const;
    std::int64_t toCapacity(double cost) const;
    std::int64_t demandOf(int vertex) const { return toCapacity(mGain[vertex]) + mRouted[vertex]; }

    const LabelingProblem &mProblem;
    std::vector<int> mLabels;
    double mEnergy = 0.0;

    std::vector<int> mFirstNeighbour; // vertexCount + 1 offsets into mNeighbours
    std::vector<int> mNeighbours;
    std::vector<double> mNeighbourWeights;

    // What follows from the labels.
    std::vector<double> mKeepCost; // D_v(l_v)
    std::vector<double> mBorder;   // half the weight of the vertex' edges to other labels
    std::vector<int> mFirstMember; // labelCount + 1 offsets into mMembers
    std::vector<int> mMembers;     // vertices sorted by label

    // Of the move under way.
    int mAlpha = -1;
    double mScale = 1.0;               // capacity units a unit of energy
    std::vector<double> mGain;         // what a vertex saves on its own by taking alpha
    std::vector<std::int64_t> mRouted; // flow vertex -> label node fixed in advance
    std::vector<int> mRoutedVertices;
    std::vector<std::int64_t> mUnmet; // per label: what is left of its cost's arc to the sink
    std::vector<int> mNodeOfItem;     // vertices, then labels; -1 is not in the graph
    std::vector<int> mItemOfNode;
    std::vector<int> mUnexpanded; // nodes whose neighbours may still be missing
    std::vector<char> mTaken;     // per vertex, 1 = takes alpha
    std::vector<int> mTakers;
    std::unique_ptr<Flow> mFlow;
};

} // namespace ductus
