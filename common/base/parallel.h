// Parallel loops over index ranges (TBB). Bodies must write only to their own index: results never depend
// on the number of cores. Sums go through parallelSum, whose chunks and order are fixed.
#pragma once

#include <cstddef>
#include <functional>

namespace ductus {

/// Calls body(i) for begin <= i < end, in any order, at most \a grain indices a task.
void parallelFor(std::size_t begin, std::size_t end, const std::function<void(std::size_t)> &body,
                 std::size_t grain = 1);

/// Calls body(chunkBegin, chunkEnd) on disjoint chunks of fixed size \a chunk.
void parallelChunks(std::size_t count, std::size_t chunk,
                    const std::function<void(std::size_t, std::size_t)> &body);

/// Sum of term(i); bit-identical for any number of threads.
double parallelSum(std::size_t count, const std::function<double(std::size_t)> &term);

} // namespace ductus
