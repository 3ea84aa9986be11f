#include "sketchsurfacer/ui/presentation/region_palette.h"

#include "geometry/mesh_topology.h"
#include "imaging/region_colours.h"

#include <algorithm>
#include <set>

namespace ductus {

namespace {

using Neighbours = std::set<std::pair<int, int>>;

Neighbours neighbouringRegions(const TriangleMesh &mesh, const std::vector<int> &triangleRegions)
{
    Neighbours neighbours;
    for (const MeshEdge &edge : MeshTopology(mesh).edges) {
        if (edge.faceCount != 2)
            continue;
        const int a = triangleRegions[std::size_t(edge.faces[0])];
        const int b = triangleRegions[std::size_t(edge.faces[1])];
        if (a != b)
            neighbours.emplace(std::min(a, b), std::max(a, b));
    }
    return neighbours;
}

// The colour number furthest from those of \a taken, one that is not \a used anywhere as long as there is
// one.
int mostDifferent(const std::vector<int> &taken, const std::vector<int> &used)
{
    const auto isUsed = [&](int number) { return std::find(used.begin(), used.end(), number) != used.end(); };
    int best = 0;
    double largest = -1e12;
    for (int number = 0; number < regionColourCount; ++number) {
        double nearest = 1e9;
        for (int other : taken)
            nearest = std::min(nearest, colourDistance(regionColour(number), regionColour(other)));
        if (isUsed(number))
            nearest -= 1e6;
        if (isUsed(number))
            nearest -= 1e6;
        if (nearest > largest) {
            largest = nearest;
            best = number;
        }
    }
    return best;
}

} // namespace

std::vector<Rgba> RegionPalette::colours(const TriangleMesh &mesh, const std::vector<int> &triangleRegions,
                                         const std::vector<int> &regionIds)
{
    const Neighbours neighbours = neighbouringRegions(mesh, triangleRegions);
    const int count = int(regionIds.size());
    std::vector<int> numbers(regionIds.size(), -1);
    int known = 0;
    for (int r = 0; r < count; ++r)
        if (const auto found = mNumberOfId.find(regionIds[std::size_t(r)]); found != mNumberOfId.end()) {
            numbers[std::size_t(r)] = found->second;
            ++known;
        }
    if (2 * known < count) { // another sketch, or all new: the best choice over all
        numbers = assignRegionColours(count, {neighbours.begin(), neighbours.end()});
    } else {
        std::vector<std::vector<int>> around(regionIds.size());
        for (const auto &[a, b] : neighbours) {
            around[std::size_t(a)].push_back(b);
            around[std::size_t(b)].push_back(a);
        }
        for (int r = 0; r < count; ++r) {
            std::vector<int> taken;
            for (int other : around[std::size_t(r)])
                if (numbers[std::size_t(other)] >= 0)
                    taken.push_back(numbers[std::size_t(other)]);
            int &number = numbers[std::size_t(r)];
            if (number < 0 || std::find(taken.begin(), taken.end(), number) != taken.end())
                number = mostDifferent(taken, numbers);
        }
    }
    mNumberOfId.clear();
    std::vector<Rgba> colours;
    for (int r = 0; r < count; ++r) {
        mNumberOfId[regionIds[std::size_t(r)]] = numbers[std::size_t(r)];
        colours.push_back(regionColour(numbers[std::size_t(r)]));
    }
    return colours;
}

} // namespace ductus
