// What a print check found, in sentences a designer understands, at the size it is to be printed in.
#pragma once

#include "geometry/inspection/print_check.h"

#include <QLocale>
#include <QString>
#include <vector>

namespace ductus {

enum class FindingKind { Good, Doubtful, Bad };

/// A place in the scene and, of a wall or gap, its other side.
struct FoundPlace
{
    Vec3 at = Vec3::Zero();
    std::optional<Vec3> other;
    QString text; // a few words to stand beside it
};

struct PrintFinding
{
    QString id; // "watertight", "wall", "gap", "crossing", "overlap"
    FindingKind kind = FindingKind::Good;
    QString text;
    std::optional<FoundPlace> place;
};

struct PrintSize
{
    double metresPerUnit = 1.0;   // of the print: of the scene as it will lie on the printer
    double nozzleMetres = 0.0004; // the width of a line
};

/// Worst first.
std::vector<PrintFinding> printFindings(const PrintCheck &check, const PrintSize &size,
                                        const QLocale &locale);

} // namespace ductus
