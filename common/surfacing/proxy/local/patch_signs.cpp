#include "surfacing/proxy/local/patch_signs.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace ductus {

namespace {

struct Neighbour
{
    int patch;
    double agreement;
};

using Neighbours = std::vector<std::vector<Neighbour>>;

Neighbours neighboursOf(const std::vector<PatchAgreement> &agreements, std::size_t count)
{
    Neighbours neighbours(count);
    for (const PatchAgreement &edge : agreements) {
        neighbours[std::size_t(edge.a)].push_back({edge.b, edge.agreement});
        neighbours[std::size_t(edge.b)].push_back({edge.a, edge.agreement});
    }
    return neighbours;
}

// Kruskal: the tree of the most reliable agreements, as neighbour lists.
Neighbours reliableTree(std::vector<PatchAgreement> agreements, std::size_t count)
{
    std::stable_sort(
        agreements.begin(), agreements.end(),
        [](const PatchAgreement &a, const PatchAgreement &b) { return a.reliability > b.reliability; });
    std::vector<int> parent(count);
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int i) {
        while (parent[std::size_t(i)] != i) {
            parent[std::size_t(i)] = parent[std::size_t(parent[std::size_t(i)])];
            i = parent[std::size_t(i)];
        }
        return i;
    };
    std::vector<PatchAgreement> kept;
    for (const PatchAgreement &edge : agreements) {
        const int a = root(edge.a), b = root(edge.b);
        if (a == b)
            continue;
        parent[std::size_t(a)] = b;
        kept.push_back(edge);
    }
    return neighboursOf(kept, count);
}

// What the sum loses, halved, if all patches of \a piece turn over.
double turningLoss(const std::vector<int> &piece, const std::vector<char> &isInPiece,
                   const std::vector<int> &signs, const Neighbours &neighbours,
                   const std::vector<double> &rough)
{
    double loss = 0.0;
    for (int a : piece) {
        loss += signs[std::size_t(a)] * rough[std::size_t(a)];
        for (const Neighbour &n : neighbours[std::size_t(a)])
            if (!isInPiece[std::size_t(n.patch)])
                loss += signs[std::size_t(a)] * signs[std::size_t(n.patch)] * n.agreement;
    }
    return loss;
}

// Connected patches for which \a wanted holds, \a start among them; marked.
template <typename Wanted>
std::vector<int> pieceFrom(int start, const Neighbours &neighbours, std::vector<char> &isMarked,
                           const Wanted &wanted)
{
    std::vector<int> piece{start};
    isMarked[std::size_t(start)] = 1;
    for (std::size_t i = 0; i < piece.size(); ++i)
        for (const Neighbour &n : neighbours[std::size_t(piece[i])])
            if (!isMarked[std::size_t(n.patch)] && wanted(n.patch)) {
                isMarked[std::size_t(n.patch)] = 1;
                piece.push_back(n.patch);
            }
    return piece;
}

std::vector<int> signsAlong(const Neighbours &tree, const std::vector<double> &rough)
{
    std::vector<int> signs(tree.size(), 0);
    for (std::size_t start = 0; start < tree.size(); ++start) {
        if (signs[start])
            continue;
        std::vector<int> reached{int(start)};
        signs[start] = 1;
        double agreement = 0.0;
        for (std::size_t i = 0; i < reached.size(); ++i) {
            const std::size_t a = std::size_t(reached[i]);
            agreement += signs[a] * rough[a];
            for (const Neighbour &n : tree[a])
                if (!signs[std::size_t(n.patch)]) {
                    signs[std::size_t(n.patch)] = n.agreement < 0.0 ? -signs[a] : signs[a];
                    reached.push_back(n.patch);
                }
        }
        if (agreement < 0.0)
            for (int a : reached)
                signs[std::size_t(a)] *= -1;
    }
    return signs;
}

} // namespace

std::vector<int> consistentSigns(const std::vector<PatchAgreement> &agreements,
                                 const std::vector<double> &rough)
{
    const Neighbours neighbours = neighboursOf(agreements, rough.size());
    std::vector<int> signs = signsAlong(reliableTree(agreements, rough.size()), rough);

    std::vector<char> isSeen(rough.size(), 0);
    const auto differs = [&](int a) { return signs[std::size_t(a)] * rough[std::size_t(a)] < 0.0; };
    for (std::size_t start = 0; start < rough.size(); ++start) {
        if (isSeen[start] || !differs(int(start)))
            continue;
        const std::vector<int> piece = pieceFrom(int(start), neighbours, isSeen, differs);
        std::vector<char> isInPiece(rough.size(), 0);
        for (int a : piece)
            isInPiece[std::size_t(a)] = 1;
        if (turningLoss(piece, isInPiece, signs, neighbours, rough) < 0.0)
            for (int a : piece)
                signs[std::size_t(a)] *= -1;
    }
    constexpr int mostRounds = 20; // each turn gains, so this ends; rounding could prolong it
    const std::vector<char> none(rough.size(), 0);
    for (int round = 0, turned = 1; round < mostRounds && turned > 0; ++round) {
        turned = 0;
        for (std::size_t a = 0; a < rough.size(); ++a)
            if (turningLoss({int(a)}, none, signs, neighbours, rough) < 0.0) {
                signs[a] *= -1;
                ++turned;
            }
    }
    return signs;
}

} // namespace ductus
