// Seeded random numbers that are the same on every machine and library (std distributions are not).
// Generator: SplitMix64 [Steele, Lea, Flood 2014].
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace ductus {

class Random
{
public:
    explicit Random(std::uint64_t seed) : mState(seed) {}

    std::uint64_t next();

    /// Uniform in [0, 1).
    double uniform();

    /// Uniform in [low, high).
    double uniform(double low, double high) { return low + (high - low) * uniform(); }

    /// Uniform in 0 .. count-1; \a count > 0.
    int index(int count);

    /// Standard normal (Box-Muller).
    double normal();

    template <typename T>
    void shuffle(std::vector<T> &items)
    {
        for (int i = int(items.size()) - 1; i > 0; --i)
            std::swap(items[std::size_t(i)], items[std::size_t(index(i + 1))]);
    }

    /// An independent stream, for run number \a stream of a parallel loop.
    Random fork(std::uint64_t stream) const;

private:
    std::uint64_t mState;
};

} // namespace ductus
