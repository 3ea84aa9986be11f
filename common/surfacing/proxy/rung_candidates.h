// Several tries at one rung of the proxy's ladder (proxy.h), of which the one in best order counts.
#pragma once

#include "surfacing/proxy/rungs.h"

namespace ductus {

struct RungCandidate
{
    ProxyGround ground; // with the wrap that was taken
    double lambda = 0.0;
    Result<ProxyRung> rung;
};

/// The rung of \a kind with the least disorder: on \a ground with \a lambda; where that is in disorder, for a
/// solid on looser wraps; and where it has tunnels, with more smoothing. \a drawn: samples of \a strokes.
RungCandidate calmest(ProxyKind kind, const ProxyGround &ground, const StrokeSet &strokes,
                      const std::vector<Vec3> &drawn, double lambda, const ProxyOptions &options,
                      const JobControl &control);

} // namespace ductus
