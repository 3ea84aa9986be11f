#include "base/parallel.h"

#include <algorithm>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <vector>

namespace ductus {

void parallelFor(std::size_t begin, std::size_t end, const std::function<void(std::size_t)> &body,
                 std::size_t grain)
{
    if (begin >= end)
        return;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(begin, end, std::max<std::size_t>(grain, 1)),
                      [&](const tbb::blocked_range<std::size_t> &range) {
                          for (std::size_t i = range.begin(); i != range.end(); ++i)
                              body(i);
                      });
}

void parallelChunks(std::size_t count, std::size_t chunk,
                    const std::function<void(std::size_t, std::size_t)> &body)
{
    chunk = std::max<std::size_t>(chunk, 1);
    const std::size_t chunks = (count + chunk - 1) / chunk;
    parallelFor(0, chunks, [&](std::size_t i) { body(i * chunk, std::min(count, (i + 1) * chunk)); });
}

double parallelSum(std::size_t count, const std::function<double(std::size_t)> &term)
{
    constexpr std::size_t chunk = 1024;
    std::vector<double> partial((count + chunk - 1) / chunk, 0.0);
    parallelChunks(count, chunk, [&](std::size_t begin, std::size_t end) {
        double sum = 0.0;
        for (std::size_t i = begin; i != end; ++i)
            sum += term(i);
        partial[begin / chunk] = sum;
    });
    double total = 0.0;
    for (double sum : partial)
        total += sum;
    return total;
}

} // namespace ductus
