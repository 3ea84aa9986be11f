// The symbolic half of a multifrontal Cholesky factorisation [Duff, Reid 1983; Liu 1992]: which columns of
// the factor share their rows (supernodes), and what goes where when their dense fronts are assembled.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace ductus {

struct Supernode
{
    int firstColumn = 0;        // in elimination order
    int width = 0;              // number of columns
    int parent = -1;            // supernode, later in the list; -1 for a root
    int height = 0;             // rows of the front: the columns themselves, then the rows below
    std::size_t firstRow = 0;   // into Supernodes::rows, height entries
    std::size_t firstValue = 0; // of the height x width panel of the factor, column-major
    std::vector<int> children;

    int below() const { return height - width; }
};

struct Supernodes
{
    std::vector<int> order;       // position -> row of the matrix
    std::vector<Supernode> nodes; // children before parents
    std::vector<int> rows;        // positions, ascending within a supernode
    std::vector<int> rowInParent; // beside rows: place of a row below in the parent's front
    std::vector<int> entryStart;  // size + 1 offsets of the matrix entries by eliminated column
    std::vector<int> entryValue;  // index into the matrix' values
    std::vector<int> entryRow;    // place of the entry's row in its supernode's front
    std::size_t valueCount = 0;   // of the whole factor
};

/// \a matrix: square, compressed; the lower triangle is read. \a order as from fillReducingOrder(); the
/// result's order is an equivalent one in which subtrees are contiguous.
Supernodes findSupernodes(const Eigen::SparseMatrix<double> &matrix, const std::vector<int> &order);

} // namespace ductus
