#include "numeric/supernodes.h"

#include <algorithm>
#include <numeric>

namespace ductus {

namespace {

// For each position, the positions before it that it shares an entry with.
struct RowPattern
{
    std::vector<int> start;
    std::vector<int> columns;
};

std::vector<int> inverseOf(const std::vector<int> &order)
{
    std::vector<int> inverse(order.size());
    for (int position = 0; position < int(order.size()); ++position)
        inverse[order[position]] = position;
    return inverse;
}

template <typename Visit>
void forEachEntry(const Eigen::SparseMatrix<double> &matrix, const std::vector<int> &position,
                  const Visit &visit)
{
    for (int column = 0; column < int(matrix.cols()); ++column) {
        for (int i = matrix.outerIndexPtr()[column]; i < matrix.outerIndexPtr()[column + 1]; ++i) {
            const int row = matrix.innerIndexPtr()[i];
            if (row >= column) {
                const auto [low, high] = std::minmax(position[row], position[column]);
                visit(high, low, i);
            }
        }
    }
}

RowPattern rowPattern(const Eigen::SparseMatrix<double> &matrix, const std::vector<int> &order)
{
    const std::vector<int> position = inverseOf(order);
    RowPattern pattern;
    pattern.start.assign(order.size() + 1, 0);
    forEachEntry(matrix, position,
                 [&](int row, int column, int) { pattern.start[row + 1] += row != column; });
    std::partial_sum(pattern.start.begin(), pattern.start.end(), pattern.start.begin());
    pattern.columns.resize(std::size_t(pattern.start.back()));
    std::vector<int> next(pattern.start.begin(), pattern.start.end() - 1);
    forEachEntry(matrix, position, [&](int row, int column, int) {
        if (row != column)
            pattern.columns[next[row]++] = column;
    });
    return pattern;
}

// Liu's algorithm with path compression.
std::vector<int> eliminationTree(const RowPattern &pattern)
{
    const int size = int(pattern.start.size()) - 1;
    std::vector<int> parent(std::size_t(size), -1);
    std::vector<int> ancestor(std::size_t(size), -1);
    for (int row = 0; row < size; ++row) {
        for (int i = pattern.start[row]; i < pattern.start[row + 1]; ++i) {
            int column = pattern.columns[i];
            while (column != -1 && column < row) {
                const int next = ancestor[column];
                ancestor[column] = row;
                if (next == -1)
                    parent[column] = row;
                column = next;
            }
        }
    }
    return parent;
}

// Old positions in post-order, without recursion: trees may be as deep as the matrix is large.
std::vector<int> postOrder(const std::vector<int> &parent)
{
    const int size = int(parent.size());
    std::vector<int> firstChild(parent.size(), -1);
    std::vector<int> nextSibling(parent.size(), -1);
    std::vector<int> stack;
    for (int v = size - 1; v >= 0; --v) {
        if (parent[v] < 0) {
            stack.push_back(v);
        } else {
            nextSibling[v] = firstChild[parent[v]];
            firstChild[parent[v]] = v;
        }
    }
    std::vector<int> result;
    result.reserve(parent.size());
    while (!stack.empty()) {
        const int v = stack.back();
        if (const int child = firstChild[v]; child >= 0) {
            firstChild[v] = nextSibling[child];
            stack.push_back(child);
        } else {
            result.push_back(v);
            stack.pop_back();
        }
    }
    return result;
}

// Entries in each column of the factor, diagonal included: row i of it is the tree paths from row i's entries
// to i.
std::vector<int> columnCounts(const RowPattern &pattern, const std::vector<int> &parent)
{
    const int size = int(parent.size());
    std::vector<int> counts(parent.size(), 1);
    std::vector<int> seen(parent.size(), -1);
    for (int row = 0; row < size; ++row) {
        seen[row] = row;
        for (int i = pattern.start[row]; i < pattern.start[row + 1]; ++i) {
            for (int column = pattern.columns[i]; seen[column] != row; column = parent[column]) {
                seen[column] = row;
                ++counts[column];
            }
        }
    }
    return counts;
}

struct Group
{
    int first = 0;
    int width = 0;
    int below = 0;
    double zeros = 0.0; // entries stored although the factor has none there

    double stored() const { return width * (width + 1.0) / 2.0 + double(width) * below; }
};

// Joining a group with the one it hangs on stores zeros but makes denser work [Ashcraft, Grimes 1989].
bool worthJoining(const Group &joined)
{
    const double share = joined.zeros / joined.stored();
    return joined.width <= 8 || (joined.width <= 24 && share < 0.4) || (joined.width <= 64 && share < 0.12) ||
           share < 0.04;
}

std::vector<Group> groupColumns(const std::vector<int> &parent, const std::vector<int> &counts)
{
    std::vector<Group> exact;
    for (int column = 0; column < int(parent.size()); ++column) {
        const bool continues =
            column > 0 && parent[column - 1] == column && counts[column - 1] == counts[column] + 1;
        if (!continues)
            exact.push_back({column, 0, 0, 0.0});
        ++exact.back().width;
        exact.back().below = counts[column] - 1;
    }
    std::vector<Group> groups;
    for (Group group : exact) {
        while (!groups.empty()) {
            // Contiguous by construction; they join only if the last column's parent is this group's first.
            const Group &child = groups.back();
            if (parent[child.first + child.width - 1] < group.first ||
                parent[child.first + child.width - 1] >= group.first + group.width)
                break;
            Group joined{child.first, child.width + group.width, group.below, child.zeros + group.zeros};
            joined.zeros += double(child.width) * (group.width + group.below - child.below);
            if (!worthJoining(joined))
                break;
            group = joined;
            groups.pop_back();
        }
        groups.push_back(group);
    }
    return groups;
}

// The rows below a front: those of its own entries and of its children's fronts.
void findRows(Supernodes &result, const std::vector<std::vector<int>> &rowsOfColumn)
{
    const int size = int(rowsOfColumn.size());
    std::vector<int> seen(std::size_t(size), -1);
    for (int s = 0; s < int(result.nodes.size()); ++s) {
        Supernode &node = result.nodes[s];
        const int end = node.firstColumn + node.width;
        node.firstRow = result.rows.size();
        const auto add = [&](int row) {
            if (row >= end && seen[row] != s) {
                seen[row] = s;
                result.rows.push_back(row);
            }
        };
        for (int column = node.firstColumn; column < end; ++column)
            result.rows.push_back(column);
        for (int column = node.firstColumn; column < end; ++column) {
            for (int row : rowsOfColumn[column])
                add(row);
        }
        for (int child : node.children) {
            const Supernode &from = result.nodes[child];
            for (int i = from.width; i < from.height; ++i)
                add(result.rows[from.firstRow + i]);
        }
        std::sort(result.rows.begin() + std::ptrdiff_t(node.firstRow), result.rows.end());
        node.height = int(result.rows.size() - node.firstRow);
        node.firstValue = result.valueCount;
        result.valueCount += std::size_t(node.height) * std::size_t(node.width);
    }
}

int placeInFront(const Supernodes &supernodes, const Supernode &node, int row)
{
    const auto begin = supernodes.rows.begin() + std::ptrdiff_t(node.firstRow);
    return int(std::lower_bound(begin, begin + node.height, row) - begin);
}

} // namespace

Supernodes findSupernodes(const Eigen::SparseMatrix<double> &matrix, const std::vector<int> &order)
{
    const int size = int(order.size());
    Supernodes result;
    const std::vector<int> tree = eliminationTree(rowPattern(matrix, order));
    for (int position : postOrder(tree))
        result.order.push_back(order[position]);

    const RowPattern pattern = rowPattern(matrix, result.order);
    const std::vector<int> parent = eliminationTree(pattern);
    std::vector<int> groupOf(std::size_t(size), 0);
    for (const Group &group : groupColumns(parent, columnCounts(pattern, parent))) {
        std::fill_n(groupOf.begin() + group.first, group.width, int(result.nodes.size()));
        Supernode node;
        node.firstColumn = group.first;
        node.width = group.width;
        result.nodes.push_back(node);
    }
    for (int s = 0; s < int(result.nodes.size()); ++s) {
        Supernode &node = result.nodes[s];
        const int up = parent[node.firstColumn + node.width - 1];
        if (up >= 0) {
            node.parent = groupOf[up];
            result.nodes[node.parent].children.push_back(s);
        }
    }

    std::vector<std::vector<int>> rowsOfColumn(order.size());
    for (int row = 0; row < size; ++row) {
        for (int i = pattern.start[row]; i < pattern.start[row + 1]; ++i)
            rowsOfColumn[pattern.columns[i]].push_back(row);
    }
    findRows(result, rowsOfColumn);

    result.rowInParent.assign(result.rows.size(), -1);
    for (const Supernode &node : result.nodes) {
        for (int i = node.width; i < node.height; ++i)
            result.rowInParent[node.firstRow + i] =
                placeInFront(result, result.nodes[node.parent], result.rows[node.firstRow + i]);
    }

    const std::vector<int> position = inverseOf(result.order);
    result.entryStart.assign(std::size_t(size) + 1, 0);
    forEachEntry(matrix, position, [&](int, int column, int) { ++result.entryStart[column + 1]; });
    std::partial_sum(result.entryStart.begin(), result.entryStart.end(), result.entryStart.begin());
    result.entryValue.resize(std::size_t(result.entryStart.back()));
    result.entryRow.resize(std::size_t(result.entryStart.back()));
    std::vector<int> next(result.entryStart.begin(), result.entryStart.end() - 1);
    forEachEntry(matrix, position, [&](int row, int column, int value) {
        result.entryValue[next[column]] = value;
        result.entryRow[next[column]++] = placeInFront(result, result.nodes[groupOf[column]], row);
    });
    return result;
}

} // namespace ductus
