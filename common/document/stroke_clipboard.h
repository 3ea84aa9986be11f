// Strokes on the clipboard, for all apps of the suite: a format of our own with everything there is to know,
// and plain text (the lines of a .curves file) for other programs.
#pragma once

#include "base/result.h"
#include "strokes/stroke.h"

#include <QMimeData>
#include <memory>
#include <optional>

namespace ductus {

/// A stroke with how it was painted, as far as the app it comes from paints.
struct CopiedStroke
{
    Stroke line;                           // its id means nothing
    std::vector<double> halfWidths;        // one a point in the unit of the points, or empty
    std::optional<Eigen::Vector3f> colour; // linear RGB
    double opacity = 1.0;                  // 0..1
};

struct CopiedStrokes
{
    std::vector<CopiedStroke> strokes;
    double metresPerUnit = 1.0;
    UpAxis upAxis = UpAxis::Y;
    bool isFlat = false; // drawn on a sheet: z is 0, y goes up
};

/// "application/vnd.ductus.strokes+json"
QString strokesMimeType();

/// For the clipboard.
std::unique_ptr<QMimeData> mimeDataOf(const CopiedStrokes &strokes);

bool hasStrokes(const QMimeData *data);

/// What another app, or this one, copied. TooLittleData if there are no strokes, Malformed or TooLarge for
/// what no app of the suite wrote.
Result<CopiedStrokes> strokesFrom(const QMimeData *data);

/// \a strokes in a unit of \a metresPerUnit with y or z up.
CopiedStrokes inUnit(CopiedStrokes strokes, double metresPerUnit, UpAxis upAxis);

} // namespace ductus
