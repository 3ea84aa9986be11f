#include "numeric/spectral_clustering.h"

#include "numeric/k_means.h"
#include "numeric/lowest_eigenvectors.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ductus {

namespace {

constexpr const char *attempted = "Clustering a graph by its spectrum";

Error malformed(const char *problem)
{
    return {ErrorCode::InvalidArgument, attempted, problem, "", ""};
}

Result<void> check(int vertexCount, const std::vector<LabelingEdge> &edges, int count)
{
    if (vertexCount < 0 || count < 0)
        return malformed("the number of vertices or of vectors is negative");
    double total = 0.0;
    for (const LabelingEdge &edge : edges) {
        if (edge.u < 0 || edge.u >= vertexCount || edge.v < 0 || edge.v >= vertexCount)
            return malformed("an edge names a vertex that does not exist");
        if (!(edge.weight >= 0.0))
            return malformed("an edge's affinity is negative or not a number");
        total += edge.weight;
    }
    if (!std::isfinite(total))
        return malformed("the edges' affinities are too large to add up");
    return {};
}

bool joins(const LabelingEdge &edge)
{
    return edge.u != edge.v && edge.weight > 0.0;
}

// Vertices of each component, ascending, in the order of the components' first vertices.
std::vector<std::vector<int>> findComponents(int vertexCount, const std::vector<LabelingEdge> &edges)
{
    std::vector<int> root(std::size_t(vertexCount), 0);
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&](int v) {
        while (root[v] != v)
            v = root[v] = root[root[v]];
        return v;
    };
    for (const LabelingEdge &edge : edges) {
        if (joins(edge)) {
            const int a = find(edge.u);
            const int b = find(edge.v);
            root[std::max(a, b)] = std::min(a, b);
        }
    }
    std::vector<std::vector<int>> components;
    std::vector<int> componentOf(std::size_t(vertexCount), -1);
    for (int v = 0; v < vertexCount; ++v) {
        const int first = find(v);
        if (first == v) {
            componentOf[v] = int(components.size());
            components.emplace_back();
        }
        components[componentOf[first]].push_back(v);
    }
    return components;
}

struct Graph
{
    std::vector<LabelingEdge> edges;
    std::vector<double> degrees;
    std::vector<int> place; // of a vertex within its component
};

// I - D^-1/2 W D^-1/2 of one component, whose edges are given.
Eigen::SparseMatrix<double> normalizedLaplacian(const Graph &graph, const std::vector<int> &vertices,
                                                const std::vector<int> &edges)
{
    std::vector<Eigen::Triplet<double>> triplets;
    for (int i = 0; i < int(vertices.size()); ++i)
        triplets.emplace_back(i, i, 1.0);
    for (int index : edges) {
        const LabelingEdge &edge = graph.edges[index];
        const double value =
            -(edge.weight / std::sqrt(graph.degrees[edge.u])) / std::sqrt(graph.degrees[edge.v]);
        triplets.emplace_back(graph.place[edge.u], graph.place[edge.v], value);
        triplets.emplace_back(graph.place[edge.v], graph.place[edge.u], value);
    }
    Eigen::SparseMatrix<double> matrix{Eigen::Index(vertices.size()), Eigen::Index(vertices.size())};
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    return matrix;
}

// The exact eigenvector of eigenvalue 0; a vertex without edges is a component of its own.
Eigen::VectorXd nullVector(const Graph &graph, const std::vector<int> &vertices)
{
    if (vertices.size() == 1)
        return Eigen::VectorXd::Ones(1);
    double largest = 0.0; // guards the squares of the norm
    for (int v : vertices)
        largest = std::max(largest, graph.degrees[v]);
    Eigen::VectorXd vector{Eigen::Index(vertices.size())};
    for (std::size_t i = 0; i < vertices.size(); ++i)
        vector[Eigen::Index(i)] = std::sqrt(graph.degrees[vertices[i]] / largest);
    return vector.normalized();
}

struct Candidate
{
    double value = 0.0;
    int component = 0;
    Eigen::VectorXd vector; // over the component's vertices
};

} // namespace

Result<Eigen::MatrixXd> spectralEmbedding(int vertexCount, const std::vector<LabelingEdge> &edges, int count,
                                          const JobControl &control)
{
    if (const Result<void> checked = check(vertexCount, edges, count); !checked)
        return checked.error();
    const std::vector<std::vector<int>> components = findComponents(vertexCount, edges);
    Graph graph{edges, std::vector<double>(std::size_t(vertexCount), 0.0),
                std::vector<int>(std::size_t(vertexCount), 0)};
    std::vector<int> componentOf(std::size_t(vertexCount), 0);
    for (int c = 0; c < int(components.size()); ++c) {
        for (int i = 0; i < int(components[c].size()); ++i) {
            componentOf[components[c][i]] = c;
            graph.place[components[c][i]] = i;
        }
    }
    std::vector<std::vector<int>> edgesOf(components.size());
    for (int index = 0; index < int(edges.size()); ++index) {
        const LabelingEdge &edge = edges[index];
        if (joins(edge)) {
            graph.degrees[edge.u] += edge.weight;
            graph.degrees[edge.v] += edge.weight;
            edgesOf[componentOf[edge.u]].push_back(index);
        }
    }

    // Eigenvalue 0 has one vector a component; the largest components' come first.
    std::vector<Candidate> candidates;
    for (int c = 0; c < int(components.size()); ++c)
        candidates.push_back({0.0, c, nullVector(graph, components[c])});
    std::stable_sort(candidates.begin(), candidates.end(), [&](const Candidate &a, const Candidate &b) {
        return components[a.component].size() > components[b.component].size();
    });
    // Each component on its own: together, like components would have eigenvalues of any multiplicity.
    const int wanted = count - int(components.size());
    for (int c = 0; c < int(components.size()) && wanted > 0; ++c) {
        const JobControl part =
            control.part(double(c) / double(components.size()), double(c + 1) / double(components.size()));
        if (control.isCancelled())
            return cancelledError(attempted);
        if (components[c].size() < 2)
            continue;
        const Result<Eigenpairs> pairs =
            lowestEigenpairs(normalizedLaplacian(graph, components[c], edgesOf[c]), wanted + 1, part);
        if (!pairs)
            return pairs.error();
        for (Eigen::Index i = 1; i < pairs->values.size(); ++i)
            candidates.push_back({pairs->values[i], c, pairs->vectors.col(i)});
    }
    if (control.isCancelled())
        return cancelledError(attempted);
    std::stable_sort(candidates.begin() + std::ptrdiff_t(components.size()), candidates.end(),
                     [](const Candidate &a, const Candidate &b) { return a.value < b.value; });

    const int columns = std::min(count, int(candidates.size()));
    Eigen::MatrixXd embedding = Eigen::MatrixXd::Zero(vertexCount, columns);
    for (int column = 0; column < columns; ++column) {
        const Candidate &candidate = candidates[column];
        Eigen::Index strongest = 0;
        candidate.vector.cwiseAbs().maxCoeff(&strongest);
        const double sign = candidate.vector[strongest] < 0.0 ? -1.0 : 1.0;
        for (std::size_t i = 0; i < components[candidate.component].size(); ++i)
            embedding(components[candidate.component][i], column) = sign * candidate.vector[Eigen::Index(i)];
    }
    control.progress(1.0, attempted);
    return embedding;
}

std::vector<int> spectralClusters(const Eigen::MatrixXd &embedding, int clusterCount, Random random)
{
    const Eigen::Index columns = std::min<Eigen::Index>(std::max(clusterCount, 0), embedding.cols());
    // One point a column: k-means walks along points.
    Eigen::MatrixXd points = embedding.leftCols(columns).transpose();
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        const double norm = points.col(i).norm();
        if (norm > 0.0)
            points.col(i) /= norm;
    }
    return kMeans(points, clusterCount, random);
}

} // namespace ductus
