// How much the energy of the segmentation (Eq. III.1) depends on its random start: single runs and the best
// of ten, with the thesis' first models and with weaker ones (Fig. III.10).
#pragma once

#include "benchmarks/surfacing/benchmark_context.h"
#include "support/solids.h"

namespace ductus {

SectionReport energySpread(const BenchmarkContext &context, const std::vector<Solid> &solids);

} // namespace ductus
