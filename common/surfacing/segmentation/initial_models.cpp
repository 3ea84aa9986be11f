#include "surfacing/segmentation/initial_models.h"

#include "base/parallel.h"
#include "numeric/spectral_clustering.h"
#include "surfacing/segmentation/region_fit.h"

#include <algorithm>

namespace ductus {

Result<Eigen::MatrixXd> proxyEmbedding(const Association &association, const MeshTopology &topology,
                                       const SegmentationOptions &options, const JobControl &control)
{
    std::vector<LabelingEdge> edges;
    edges.reserve(topology.edges.size());
    for (std::size_t e = 0; e < topology.edges.size(); ++e)
        edges.push_back({topology.edges[e].v0, topology.edges[e].v1, association.edgeWeights[e]});
    const int count = *std::max_element(options.clusterCounts.begin(), options.clusterCounts.end());
    return spectralEmbedding(int(association.pointsOfVertex.size()), edges, count, control);
}

std::vector<ImplicitPolynomial> initialModels(const Association &association,
                                              const Eigen::MatrixXd &embedding,
                                              const SegmentationOptions &options, Random random)
{
    ModelFitOptions fit = options.fit;
    fit.boost = options.initialBoost;
    std::vector<RegionSupport> supports;
    for (std::size_t round = 0; round < options.clusterCounts.size(); ++round) {
        const int clusterCount = std::min<int>(options.clusterCounts[round], int(embedding.cols()));
        const std::vector<int> clusters = spectralClusters(embedding, clusterCount, random.fork(round));
        for (int c = 0; c < clusterCount; ++c) {
            std::vector<char> flags(clusters.size());
            for (std::size_t v = 0; v < clusters.size(); ++v)
                flags[v] = clusters[v] == c;
            RegionSupport support = supportOf(association, flags);
            if (!support.points.empty())
                supports.push_back(std::move(support));
        }
    }
    const std::size_t degrees = options.initialDegrees.size();
    std::vector<ImplicitPolynomial> models(supports.size() * degrees);
    parallelFor(0, models.size(), [&](std::size_t i) {
        const int degree = std::min(options.initialDegrees[i % degrees], options.maxDegree);
        models[i] = fitRegion(association, supports[i / degrees], degree, fit);
    });
    return models;
}

} // namespace ductus
