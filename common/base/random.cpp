#include "base/random.h"

#include "base/assert.h"

#include <cmath>
#include <numbers>

namespace ductus {

std::uint64_t Random::next()
{
    std::uint64_t z = (mState += 0x9e3779b97f4a7c15ull);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
}

double Random::uniform()
{
    return double(next() >> 11) * 0x1.0p-53;
}

int Random::index(int count)
{
    DUCTUS_ASSERT(count > 0);
    return int(next() % std::uint64_t(count));
}

double Random::normal()
{
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
}

Random Random::fork(std::uint64_t stream) const
{
    Random mixed(mState ^ (0xd1b54a32d192ed03ull * (stream + 1)));
    mixed.next();
    return mixed;
}

} // namespace ductus
