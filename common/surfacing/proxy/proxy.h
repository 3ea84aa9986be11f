// Proxy: the rough manifold the strokes are read on (thesis Sec. III.6). Made automatically by a ladder, or
// cleaned from a mesh made elsewhere; always remeshed to even triangles and attracted to the strokes.
//
// The ladder, first rung that stands wins:
// 0. local, only where there are more well-spread points than the dense solver takes (dense sketches, clouds
//    of points): the same field in many small pieces, local/local_fit.h;
// 1. variational: the smooth field of variational_fit.h, contoured inside the neighbourhood of the wrap. For
//    a solid the wrap also says, loosely, where the surface is between the strokes, and the contour is
//    closed; for a shell (wrap_proxy.h, or where boundary strokes are marked) the contour ends with the
//    neighbourhood. A solid's wrap that has fallen in between strokes is seen from the contour's disorder
//    (rungs.h), and a looser one is taken; where tunnels are left, more smoothing;
// 2. the same with more smoothing;
// 3. wrap: CGAL's alpha wrap of the strokes, closed and manifold by construction.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "strokes/stroke.h"
#include "surfacing/proxy/flat_ends.h"
#include "surfacing/proxy/lambda_choice.h"
#include "surfacing/proxy/local/local_fit_options.h"
#include "surfacing/proxy/proxy_quality.h"
#include "surfacing/proxy/wrap_proxy.h"

#include <string>

namespace ductus {

/// See ProxyRung::disorder.
struct DisorderLimits
{
    double most = 0.05;    // with more, looser wraps are tried ...
    int looserWraps = 5;   // ... so many; but since they web over what is hollow ...
    double loosest = 2.5;  // ... those of more than so many times alpha ...
    double hopeless = 0.2; // ... only while it is more than this
    double tunnel = 0.02;  // that a tunnel counts
    std::vector<double> smoothings = {3.0, 10.0, 30.0}; // factors on lambda, tried in turn against tunnels
};

struct ProxyOptions
{
    int targetVertices = 12000; // of the remeshed proxy (the thesis uses about 20,000 for the whole shape)
    int fitPoints = 600;        // well-spread subset for the dense variational fit; at most about 1000
    LambdaChoiceOptions lambdaChoice;
    double retrySmoothing = 10.0;   // factor on lambda for the second rung
    double cellsAlongDiagonal = 96; // of the contouring grid
    double domainBand = 0.05; // how far outside the wrap the smooth surface may lie, share of the diagonal
    double fillerDistance =
        0.06;                  // solids: where no stroke is this near, points of the wrap say where about ...
    double fillerLambda = 3.0; // ... the surface is: nugget there, as a multiple of the strokes' ...
    double leastFillerLambda = 1e-4; // ... and at least this (unit frame)
    double holeShare = 0.35;         // shells: border loops shorter than this share of the longest are closed
    DisorderLimits disorder;
    bool allowVariational = true;    // off: wrap only
    double denseSpacing = 0.02;      // a sketch of more points this far apart ...
    int mostDensePoints = 1000;      // ... than this is fitted in pieces
    double leastLocalSpacing = 1e-3; // of the points fitted in pieces, which are ...
    int mostLocalPoints = 30'000;    // ... at most so many
    LocalFitOptions local;
    FlatEndOptions flatEnds;
    ProxyQualityLimits quality;
    WrapOptions wrap;
};

enum class ProxyKind { Variational, Wrap, Given, Local };

struct Proxy
{
    TriangleMesh mesh; // manifold, even triangles, unit frame
    ProxyKind kind = ProxyKind::Wrap;
    bool isOpen = false;
    double lambda = 0.0;           // of the variational rung
    double alpha = 0.0;            // of the wrap
    std::vector<FlatEnd> flatEnds; // of a solid; the mesh passes through them
    std::string remarks;           // why lower rungs were taken, in words
};

std::string_view proxyKindName(ProxyKind kind);

/// \a strokes in the unit frame, all of the shape (both halves when symmetric).
Result<Proxy> makeProxy(const StrokeSet &strokes, const ProxyOptions &options, const JobControl &control);

/// \a mesh in the unit frame, repaired here; refused with the reason if it cannot be.
Result<Proxy> proxyFromMesh(const TriangleMesh &mesh, const StrokeSet &strokes, const ProxyOptions &options,
                            const JobControl &control);

} // namespace ductus
