#include "numeric/sparse_cholesky.h"

#include "base/assert.h"
#include "base/parallel.h"
#include "numeric/fill_reducing_order.h"
#include "numeric/supernodes.h"

#include <Eigen/Cholesky>
#include <Eigen/Dense>
#include <algorithm>
#include <atomic>
#include <cmath>

namespace ductus {

namespace {

using Eigen::MatrixXd;
using SparseMatrix = Eigen::SparseMatrix<double>;
using Panel = Eigen::Map<MatrixXd>;
using ConstPanel = Eigen::Map<const MatrixXd>;

// Depth of the dense updates. Eigen splits deeper products by the size of the machine's caches, and the order
// of the sums with them.
constexpr int panelDepth = 128;

// Columns a task in the dense updates of the large fronts.
constexpr int tileWidth = 96;

// Right-hand sides a task.
constexpr int columnsPerTask = 4;

// Fronts with less work than this (multiplications) are not worth a parallel loop.
constexpr double smallFront = 4e6;

double workOf(const Supernode &node)
{
    return double(node.width) * node.height * node.height;
}

} // namespace

struct SparseCholesky::Implementation
{
    std::vector<int> outer; // the analysed pattern
    std::vector<int> inner;
    Supernodes symbolic;
    std::vector<std::vector<int>> subtrees; // disjoint, of like work, supernodes children first
    std::vector<int> top;                   // the supernodes above them
    std::vector<double> values;
    std::vector<std::vector<double>>
        updates; // below x below, lower triangle; lives until the parent has added it
    bool analyzed = false;
    bool factorized = false;

    bool hasPattern(const SparseMatrix &matrix) const;
    void analyze(const SparseMatrix &matrix);
    void splitTree();
    bool factorize(const SparseMatrix &matrix);
    bool factorizeFront(int index, const double *entries, bool parallel);
    void assemble(const Supernode &node, const double *entries, Panel panel, Panel update);
    void solveColumns(Eigen::Ref<MatrixXd> x) const;
};

bool SparseCholesky::Implementation::hasPattern(const SparseMatrix &matrix) const
{
    return analyzed && std::size_t(matrix.cols()) + 1 == outer.size() &&
           std::size_t(matrix.nonZeros()) == inner.size() &&
           std::equal(outer.begin(), outer.end(), matrix.outerIndexPtr()) &&
           std::equal(inner.begin(), inner.end(), matrix.innerIndexPtr());
}

void SparseCholesky::Implementation::analyze(const SparseMatrix &matrix)
{
    DUCTUS_ASSERT(matrix.rows() == matrix.cols());
    outer.assign(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.cols() + 1);
    inner.assign(matrix.innerIndexPtr(), matrix.innerIndexPtr() + matrix.nonZeros());
    symbolic = findSupernodes(matrix, fillReducingOrder(matrix));
    splitTree();
    analyzed = true;
    factorized = false;
}

// Subtrees of at most an eighth of the work run side by side; what is above them has large fronts, whose
// dense updates run in parallel instead.
void SparseCholesky::Implementation::splitTree()
{
    const std::vector<Supernode> &nodes = symbolic.nodes;
    std::vector<double> work(nodes.size(), 0.0);
    double total = 0.0;
    for (std::size_t s = 0; s < nodes.size(); ++s) {
        work[s] += workOf(nodes[s]);
        total += workOf(nodes[s]);
        if (nodes[s].parent >= 0)
            work[nodes[s].parent] += work[s];
    }
    subtrees.clear();
    top.clear();
    std::vector<int> subtreeOf(nodes.size(), -1);
    double open = 0.0; // work of the last list: small neighbouring subtrees share one
    for (int s = int(nodes.size()) - 1; s >= 0; --s) {
        const int parent = nodes[s].parent;
        if (parent >= 0 && subtreeOf[parent] >= 0) {
            subtreeOf[s] = subtreeOf[parent];
        } else if (work[s] <= total / 8.0) {
            if (subtrees.empty() || open + work[s] > total / 16.0) {
                subtrees.emplace_back();
                open = 0.0;
            }
            open += work[s];
            subtreeOf[s] = int(subtrees.size()) - 1;
        }
        (subtreeOf[s] >= 0 ? subtrees[subtreeOf[s]] : top).push_back(s);
    }
    for (std::vector<int> &subtree : subtrees)
        std::reverse(subtree.begin(), subtree.end());
    std::reverse(top.begin(), top.end());
}

bool SparseCholesky::Implementation::factorize(const SparseMatrix &matrix)
{
    factorized = false;
    values.assign(symbolic.valueCount, 0.0);
    updates.assign(symbolic.nodes.size(), {});
    std::atomic<bool> positive = true;
    parallelFor(0, subtrees.size(), [&](std::size_t i) {
        for (int s : subtrees[i]) {
            if (!positive || !factorizeFront(s, matrix.valuePtr(), false)) {
                positive = false;
                return;
            }
        }
    });
    for (int s : top) {
        if (!positive)
            break;
        if (!factorizeFront(s, matrix.valuePtr(), true))
            positive = false;
    }
    updates.clear();
    factorized = positive;
    return factorized;
}

void SparseCholesky::Implementation::assemble(const Supernode &node, const double *entries, Panel panel,
                                              Panel update)
{
    for (int column = 0; column < node.width; ++column) {
        const int eliminated = node.firstColumn + column;
        for (int i = symbolic.entryStart[eliminated]; i < symbolic.entryStart[eliminated + 1]; ++i)
            panel(symbolic.entryRow[i], column) += entries[symbolic.entryValue[i]];
    }
    for (int index : node.children) {
        const Supernode &child = symbolic.nodes[index];
        const int size = child.below();
        const ConstPanel from(updates[index].data(), size, size);
        const int *place = symbolic.rowInParent.data() + child.firstRow + child.width;
        for (int column = 0; column < size; ++column) {
            const int to = place[column];
            const double *source = from.col(column).data();
            if (to < node.width) {
                double *target = panel.col(to).data();
                for (int row = column; row < size; ++row)
                    target[place[row]] += source[row];
            } else {
                double *target = update.col(to - node.width).data();
                for (int row = column; row < size; ++row)
                    target[place[row] - node.width] += source[row];
            }
        }
        updates[index] = {};
    }
}

bool SparseCholesky::Implementation::factorizeFront(int index, const double *entries, bool parallel)
{
    const Supernode &node = symbolic.nodes[index];
    const int below = node.below();
    Panel panel(values.data() + node.firstValue, node.height, node.width);
    updates[index].assign(std::size_t(below) * std::size_t(below), 0.0);
    Panel update(updates[index].data(), below, below);
    assemble(node, entries, panel, update);

    for (int first = 0; first < node.width; first += panelDepth) {
        const int depth = std::min(panelDepth, node.width - first);
        const int rest = node.height - first - depth;
        Eigen::Ref<MatrixXd> diagonal = panel.block(first, first, depth, depth);
        const Eigen::LLT<Eigen::Ref<MatrixXd>> factor(diagonal);
        if (factor.info() != Eigen::Success || !diagonal.diagonal().allFinite())
            return false;
        auto left = panel.block(first + depth, first, rest, depth);
        diagonal.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(left);
        // Columns first + depth .. height of the front, in tiles from the diagonal down.
        const auto updateTile = [&](std::size_t tile) {
            const int begin = int(tile) * tileWidth;
            const int end = std::min(rest, begin + tileWidth);
            const int inPanel = std::clamp(node.width - first - depth, begin, end);
            if (inPanel > begin)
                panel.block(first + depth + begin, first + depth + begin, rest - begin, inPanel - begin)
                    .noalias() -=
                    left.bottomRows(rest - begin) * left.middleRows(begin, inPanel - begin).transpose();
            if (end > inPanel) {
                const int column = first + depth + inPanel - node.width;
                update.block(column, column, rest - inPanel, end - inPanel).noalias() -=
                    left.bottomRows(rest - inPanel) * left.middleRows(inPanel, end - inPanel).transpose();
            }
        };
        const std::size_t tiles = std::size_t((rest + tileWidth - 1) / tileWidth);
        if (parallel && double(depth) * rest * rest > smallFront) {
            parallelFor(0, tiles, updateTile);
        } else {
            for (std::size_t tile = 0; tile < tiles; ++tile)
                updateTile(tile);
        }
    }
    return true;
}

void SparseCholesky::Implementation::solveColumns(Eigen::Ref<MatrixXd> x) const
{
    MatrixXd gathered;
    const auto rowsBelow = [&](const Supernode &node) {
        return symbolic.rows.data() + node.firstRow + node.width;
    };
    for (const Supernode &node : symbolic.nodes) {
        const ConstPanel panel(values.data() + node.firstValue, node.height, node.width);
        auto own = x.middleRows(node.firstColumn, node.width);
        panel.topRows(node.width).triangularView<Eigen::Lower>().solveInPlace(own);
        if (node.below() == 0)
            continue;
        gathered.noalias() = panel.bottomRows(node.below()) * own;
        const int *rows = rowsBelow(node);
        for (int column = 0; column < x.cols(); ++column) {
            for (int i = 0; i < node.below(); ++i)
                x(rows[i], column) -= gathered(i, column);
        }
    }
    for (std::size_t s = symbolic.nodes.size(); s-- > 0;) {
        const Supernode &node = symbolic.nodes[s];
        const ConstPanel panel(values.data() + node.firstValue, node.height, node.width);
        auto own = x.middleRows(node.firstColumn, node.width);
        if (node.below() > 0) {
            const int *rows = rowsBelow(node);
            gathered.resize(node.below(), x.cols());
            for (int column = 0; column < x.cols(); ++column) {
                for (int i = 0; i < node.below(); ++i)
                    gathered(i, column) = x(rows[i], column);
            }
            own.noalias() -= panel.bottomRows(node.below()).transpose() * gathered;
        }
        panel.topRows(node.width).triangularView<Eigen::Lower>().transpose().solveInPlace(own);
    }
}

SparseCholesky::SparseCholesky() : mImplementation(std::make_unique<Implementation>()) {}
SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky &&) noexcept = default;
SparseCholesky &SparseCholesky::operator=(SparseCholesky &&) noexcept = default;

void SparseCholesky::analyze(const Eigen::SparseMatrix<double> &matrix)
{
    if (!matrix.isCompressed()) {
        Eigen::SparseMatrix<double> compressed = matrix;
        compressed.makeCompressed();
        return analyze(compressed);
    }
    mImplementation->analyze(matrix);
}

bool SparseCholesky::factorize(const Eigen::SparseMatrix<double> &matrix)
{
    if (!matrix.isCompressed()) {
        Eigen::SparseMatrix<double> compressed = matrix;
        compressed.makeCompressed();
        return factorize(compressed);
    }
    if (!mImplementation->hasPattern(matrix))
        mImplementation->analyze(matrix);
    return mImplementation->factorize(matrix);
}

Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd &rightHandSides) const
{
    const Implementation &factor = *mImplementation;
    DUCTUS_ASSERT(factor.factorized);
    DUCTUS_ASSERT(std::size_t(rightHandSides.rows()) == factor.symbolic.order.size());
    const std::vector<int> &order = factor.symbolic.order;
    MatrixXd solution(rightHandSides.rows(), rightHandSides.cols());
    parallelChunks(std::size_t(rightHandSides.cols()), columnsPerTask,
                   [&](std::size_t begin, std::size_t end) {
                       MatrixXd x(rightHandSides.rows(), Eigen::Index(end - begin));
                       for (std::size_t column = begin; column < end; ++column) {
                           for (std::size_t i = 0; i < order.size(); ++i)
                               x(Eigen::Index(i), Eigen::Index(column - begin)) =
                                   rightHandSides(order[i], Eigen::Index(column));
                       }
                       factor.solveColumns(x);
                       for (std::size_t column = begin; column < end; ++column) {
                           for (std::size_t i = 0; i < order.size(); ++i)
                               solution(order[i], Eigen::Index(column)) =
                                   x(Eigen::Index(i), Eigen::Index(column - begin));
                       }
                   });
    return solution;
}

} // namespace ductus
