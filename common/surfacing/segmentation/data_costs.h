// Column of data costs of one model: D_v = 1/(epsilon^2 N_p) sum over P_v of Taubin's squared distance (Eq.
// III.2).
//
// Beyond the thesis: where no stroke runs, the proxy has a say. A cylinder through the rim of a can's bottom
// explains the rim as well as a plane does, and one model is cheaper than two, so the bottom would be lost.
// The proxy is crude, so only gross contradictions count: a model further away from it than proxies stray, or
// that runs across it.
#pragma once

#include "surfacing/segmentation/segmentation.h"

namespace ductus {

/// How grossly \a model contradicts the proxy at one of its vertices: 0, mostly, up to the bound.
double contradiction(const OrientedPoint &vertex, const ImplicitPolynomial &model, const ProxyPrior &prior);

std::vector<double> dataCosts(const Association &association, const ImplicitPolynomial &model, double epsilon,
                              const ProxyPrior &prior);

/// Indices into association.points of P_alpha: the points of all vertices with flag set, each once,
/// ascending.
std::vector<int> pointsOf(const Association &association, const std::vector<char> &vertexFlags);

} // namespace ductus
