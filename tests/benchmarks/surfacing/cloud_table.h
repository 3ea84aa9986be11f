// What thousands of points without normals cost, from the points to a closed proxy mesh.
#pragma once

#include "benchmarks/report/table.h"
#include "benchmarks/surfacing/benchmark_context.h"

namespace ductus {

/// Target (surfacing.md section 3): 20,000 points in under a minute on 2 cores.
Table printedCloudTable(const BenchmarkContext &context);

} // namespace ductus
