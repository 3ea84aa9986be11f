// Which strokes of a sketch are a cable or a stem and not part of a surface: proposed, so that nobody has to
// mark them.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "strokes/stroke.h"

namespace ductus {

/// A cable is told from the edge of a surface by two things together. It runs alone: no stroke is beside it
/// to hold a sheet with. And it is the only way between what its ends touch: around a stroke of a surface
/// there is another way, over the other strokes of that surface, however far away they run; the edges of a
/// large box run as alone as a cable, but the box holds together without any of them. A surface stroke taken
/// for a cable is a hole, a missed cable only the thin skin of before: where in doubt, it is none.
struct CableOptions
{
    double leastLength =
        0.25;            // share of the diagonal; as a tube and as a skin a shorter one looks much the same
    double reach = 0.06; // share of the diagonal; what is nearer is beside a stroke, or touches it. The proxy
                         // bridges gaps of about this size (ProxyOptions::fillerDistance)
    double leastAlone = 0.5;    // share of the length, in one run; the rest are ends inside what they hang on
    double leastDangling = 0.7; // the same where one end touches nothing: there is less to tell it by
    double leastChord = 0.2;    // between the ends, share of the length: rings and outlines come back
    int mostStrokes = 1500;     // of different ones; a denser sketch is no object with a cable
    int mostCables = 4;         // more than this, and lines far apart are how the sketch is drawn
};

/// Indices of strokes with role Surface, ascending. Fails only when cancelled.
Result<std::vector<int>> proposedCables(const StrokeSet &strokes, const CableOptions &options,
                                        const JobControl &control);

/// Gives the proposed ones the role Skeletal and tells which they are. Ids must differ. Strokes given twice count once.
Result<std::vector<int>> markCables(StrokeSet &strokes, const CableOptions &options, const JobControl &control);

} // namespace ductus
