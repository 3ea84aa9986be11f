// What a smooth rung of the proxy's ladder (proxy.h) is made on and gives: strokes in a wrap, and the contour
// of a field through them.
#pragma once

#include "surfacing/proxy/proxy.h"

namespace ductus {

/// What a field is fitted to.
struct ProxyGround
{
    Wrap wrap;
    bool isOpen = false;
    std::vector<FlatEnd> flatEnds; // of a solid
    std::vector<Vec3> points;      // of strokes and flat ends
    int tunnels = 0; // of a solid's wrap; that of a sheet is a thin double layer: its tunnels are holes
};

ProxyGround groundOn(Wrap wrap, const StrokeSet &strokes, const std::vector<Vec3> &drawn, bool isOpen,
                     const ProxyOptions &options);

struct ProxyRung
{
    TriangleMesh mesh;
    std::vector<Vec3> targets; // where the finished proxy is drawn to
    int tunnels = 0;           // of a sheet; of a solid those its wrap does not have
    /// How far the contour is from standing for the sketch: DisorderLimits::tunnel for each tunnel, and of a
    /// solid the share that runs out of the wrap's neighbourhood, since the field has its sides confused.
    double disorder = 0.0;
};

/// Fails with NoSolution where the contour does not stand for the strokes (proxy_quality.h). \a kind:
/// Variational, or Local for many points.
Result<ProxyRung> makeRung(ProxyKind kind, const ProxyGround &ground, double lambda,
                           const ProxyOptions &options, const JobControl &control);

} // namespace ductus
