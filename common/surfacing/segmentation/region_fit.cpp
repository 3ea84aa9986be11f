#include "surfacing/segmentation/region_fit.h"

#include "surfacing/segmentation/data_costs.h"

#include <algorithm>

namespace ductus {

namespace {

// Normals of a smooth proxy tell little more with more of them.
constexpr std::size_t enoughDirections = 400;

std::vector<int> thinned(const std::vector<int> &indices, std::size_t count)
{
    if (indices.size() <= count)
        return indices;
    std::vector<int> result(count);
    for (std::size_t i = 0; i < count; ++i)
        result[i] = indices[i * indices.size() / count];
    return result;
}

std::vector<int> unionOf(const std::vector<int> &a, const std::vector<int> &b)
{
    std::vector<int> result;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
    return result;
}

} // namespace

RegionSupport supportOf(const Association &association, const std::vector<char> &vertexFlags)
{
    RegionSupport support;
    support.points = pointsOf(association, vertexFlags);
    for (std::size_t v = 0; v < association.vertices.size(); ++v)
        if (vertexFlags[v] && association.pointsOfVertex[v].empty())
            support.freeVertices.push_back(int(v));
    return support;
}

RegionSupport supportOf(const Association &association, const std::vector<int> &vertices)
{
    std::vector<char> flags(association.pointsOfVertex.size(), 0);
    for (int v : vertices)
        flags[std::size_t(v)] = 1;
    return supportOf(association, flags);
}

RegionSupport united(const RegionSupport &a, const RegionSupport &b)
{
    return {unionOf(a.points, b.points), unionOf(a.freeVertices, b.freeVertices)};
}

ImplicitPolynomial fitRegion(const Association &association, const RegionSupport &support, int degree,
                             const ModelFitOptions &options)
{
    return fitPolynomial(association.points, support.points, association.vertices,
                         thinned(support.freeVertices, enoughDirections), degree, options);
}

} // namespace ductus
