// One proxy of several bodies: what a cable joined stands apart once the cable is a tube of its own, and a
// single smooth field or wrap would grow a neck from one to the other (the thesis' machine and cup, Fig.
// III.16: a single manifold cannot pass).
#pragma once

#include "surfacing/proxy/proxy.h"

namespace ductus {

struct PartOptions
{
    double gap = 0.06; // share of the diagonal: strokes nearer belong together; as far as the proxy bridges
    double leastExtent =
        0.08; // share of the diagonal; smaller clusters are details, and go with the nearest body
    int fewestStrokes = 3;    // of a body
    int fewestVertices = 600; // of the proxy of one
};

/// The body of each stroke, from 0; -1 for strokes that carry no surface. \a strokes in the unit frame.
std::vector<int> bodiesOf(const StrokeSet &strokes, const PartOptions &options);

/// makeProxy (proxy.h) for each body in a frame of its own, put together. Where there is one body, or one
/// gives no proxy, that of all strokes.
Result<Proxy> makePartProxy(const StrokeSet &strokes, const ProxyOptions &options, const PartOptions &parts,
                            const JobControl &control);

} // namespace ductus
