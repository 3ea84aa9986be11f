// Column of data costs of one model: D_v = 1/(epsilon^2 N_p) sum over P_v of Taubin's squared distance (Eq. III.2).
#pragma once

#include "surfacing/association/association.h"

namespace ductus {

std::vector<double> dataCosts(const Association &association, const ImplicitPolynomial &model, double epsilon);

/// Indices into association.points of P_alpha: the points of all vertices with flag set, each once, ascending.
std::vector<int> pointsOf(const Association &association, const std::vector<char> &vertexFlags);

} // namespace ductus
