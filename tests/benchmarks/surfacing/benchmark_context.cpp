#include "benchmarks/surfacing/benchmark_context.h"

#include <algorithm>

namespace ductus {

bool BenchmarkContext::wants(const std::string &solidId) const
{
    return solids.empty() || std::find(solids.begin(), solids.end(), solidId) != solids.end();
}

const std::vector<Section> &allSections()
{
    static const std::vector<Section> sections{
        {"truth", "synthetic sketches against the surfaces they were drawn from", true, runTruthSection},
        {"timing", "seconds and memory beside Table III.1 of the thesis", true, runTimingSection},
        {"proxy", "cost and exactness of the variational fit beside VIPSS", true, runProxySection},
        {"sweeps", "habits of drawing, parameters, random starts", false, runSweepSection},
    };
    return sections;
}

} // namespace ductus
