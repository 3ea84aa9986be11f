#include "surfacing/segmentation/data_costs.h"

namespace ductus {

double contradiction(const OrientedPoint &vertex, const ImplicitPolynomial &model, const ProxyPrior &prior)
{
    Vec3 gradient;
    const double ratio = model.signedDistance(vertex.point, &gradient) / prior.distance;
    const double away = std::max(0.0, ratio * ratio - 1.0);
    const double across = std::max(0.0, (prior.cosine - gradient.dot(vertex.normal)) / prior.cosine);
    return std::min(away + across, prior.bound);
}

std::vector<double> dataCosts(const Association &association, const ImplicitPolynomial &model, double epsilon,
                              const ProxyPrior &prior)
{
    std::vector<double> squared(association.points.size());
    for (std::size_t i = 0; i < squared.size(); ++i) {
        // A stray level set far from its own points can be arbitrarily wrong; a bound keeps sums finite and
        // lets one bad point weigh no more than a stroke that is a whole box away.
        const double distance = std::min(std::abs(model.signedDistance(association.points[i].point)), 1.0);
        squared[i] = distance * distance;
    }
    const double scale = 1.0 / (epsilon * epsilon * std::max(association.pairCount, 1));
    std::vector<double> costs(association.pointsOfVertex.size(), 0.0);
    for (std::size_t v = 0; v < costs.size(); ++v) {
        double sum = 0.0;
        for (int i : association.pointsOfVertex[v])
            sum += squared[std::size_t(i)];
        costs[v] = sum * scale;
    }
    double freeCount = 0.0;
    for (std::size_t v = 0; v < association.vertices.size(); ++v)
        freeCount += association.pointsOfVertex[v].empty() ? association.countAt(v) : 0.0;
    for (std::size_t v = 0; v < association.vertices.size(); ++v)
        if (association.pointsOfVertex[v].empty())
            costs[v] = prior.weight * association.countAt(v) / freeCount *
                       contradiction(association.vertices[v], model, prior);
    return costs;
}

std::vector<int> pointsOf(const Association &association, const std::vector<char> &vertexFlags)
{
    std::vector<char> used(association.points.size(), 0);
    for (std::size_t v = 0; v < vertexFlags.size(); ++v)
        if (vertexFlags[v])
            for (int i : association.pointsOfVertex[v])
                used[std::size_t(i)] = 1;
    std::vector<int> result;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i])
            result.push_back(int(i));
    return result;
}

} // namespace ductus
