// The solids all sweeps are made on: one of flat faces and sharp edges, one of smooth faces and a sharp belt.
#pragma once

#include "benchmarks/surfacing/benchmark_context.h"
#include "support/solids.h"

namespace ductus {

/// Those of them the user did not leave out.
std::vector<Solid> sweptSolids(const BenchmarkContext &context);

} // namespace ductus
