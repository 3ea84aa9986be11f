#include "benchmarks/surfacing/benchmark_context.h"

#include <algorithm>

namespace ductus {

bool BenchmarkContext::wants(const std::string &solidId) const
{
    return solids.empty() || std::find(solids.begin(), solids.end(), solidId) != solids.end();
}

bool Section::isMeantBy(const std::string &text) const
{
    return name == text || name.rfind(text + "-", 0) == 0;
}

const std::vector<Section> &allSections()
{
    static const std::vector<Section> sections{
        {"truth", "synthetic sketches against the surfaces they were drawn from", true, runTruthSection},
        {"timing", "seconds and memory beside Table III.1 of the thesis", true, runTimingSection},
        {"scribble", "seconds from a scribble to new regions and the new mesh", false, runScribbleSection},
        {"proxy", "cost and exactness of the variational fit beside VIPSS", true, runProxySection},
        {"sweeps-habits", "noise, gaps, overdrawing and missing strokes", false, runHabitSweeps},
        {"sweeps-parameters", "simplicity, epsilon, proxy resolution", false, runParameterSweeps},
        {"sweeps-starts", "energy over random starts", false, runStartSweeps},
    };
    return sections;
}

} // namespace ductus
