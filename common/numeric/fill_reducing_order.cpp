#include "numeric/fill_reducing_order.h"

#include "base/assert.h"

#include <Eigen/OrderingMethods>
#include <metis.h>
#include <mutex>
#include <numeric>

namespace ductus {

namespace {

// Below this size minimum degree is as good and far quicker.
constexpr int smallestForDissection = 1000;

std::vector<int> minimumDegreeOrder(const Eigen::SparseMatrix<double> &matrix)
{
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
    Eigen::AMDOrdering<int>()(matrix.selfadjointView<Eigen::Lower>(), permutation);
    return {permutation.indices().data(), permutation.indices().data() + permutation.size()};
}

// Empty where METIS gives up, which it only does when memory runs out.
std::vector<int> nestedDissectionOrder(std::vector<idx_t> &starts, std::vector<idx_t> &neighbours)
{
    // METIS draws from rand(), seeded anew by each call: two calls at once would mix their numbers.
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    idx_t count = idx_t(starts.size()) - 1;
    std::vector<idx_t> order(std::size_t(count), 0);
    std::vector<idx_t> position(std::size_t(count), 0);
    idx_t options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_SEED] = 1;
    const int status = METIS_NodeND(&count, starts.data(), neighbours.data(), nullptr, options, order.data(),
                                    position.data());
    if (status != METIS_OK)
        return {};
    return {order.begin(), order.end()};
}

} // namespace

std::vector<int> fillReducingOrder(const Eigen::SparseMatrix<double> &matrix)
{
    DUCTUS_ASSERT(matrix.rows() == matrix.cols() && matrix.isCompressed());
    const int size = int(matrix.rows());
    std::vector<idx_t> starts(std::size_t(size) + 1, 0);
    const auto forEachPair = [&](const auto &visit) {
        for (int column = 0; column < size; ++column) {
            for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry) {
                if (entry.row() > column)
                    visit(int(entry.row()), column);
            }
        }
    };
    forEachPair([&](int row, int column) {
        ++starts[row + 1];
        ++starts[column + 1];
    });
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    if (starts.back() == 0) {
        std::vector<int> order(std::size_t(size), 0);
        std::iota(order.begin(), order.end(), 0);
        return order;
    }
    if (size < smallestForDissection)
        return minimumDegreeOrder(matrix);
    std::vector<idx_t> neighbours(std::size_t(starts.back()), 0);
    std::vector<idx_t> next(starts.begin(), starts.end() - 1);
    forEachPair([&](int row, int column) {
        neighbours[next[row]++] = column;
        neighbours[next[column]++] = row;
    });
    std::vector<int> order = nestedDissectionOrder(starts, neighbours);
    return order.empty() ? minimumDegreeOrder(matrix) : order;
}

} // namespace ductus
