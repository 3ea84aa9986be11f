// What the journeys of SketchSurfacer share: sketches to start from, and judging what came out. Judges give
// one sentence on what is wrong, or an empty string.
#pragma once

#include "geometry/triangle_mesh.h"
#include "journeys/program_run.h"
#include "strokes/stroke.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace ductus {

/// resources/samples/ID.curves.
QString samplePath(const QString &id);

/// `surface IN -o OUT` and then \a more; 2500 proxy vertices instead of 12000 (a third of the time) unless \a
/// more says otherwise.
QStringList surfaceArguments(const QString &in, const QString &out, const QStringList &more = {});

/// The whole file; an empty array where there is none.
QByteArray bytesOf(const QString &path);
/// False if it could not be written.
bool writeBytes(const QString &path, const QByteArray &bytes);

/// Aborts the test program where a file of ours cannot be read: then nothing can be tested.
TriangleMesh meshOf(const QString &path);
StrokeSet strokesOf(const QString &path);

/// CASSIE text of polylines.
QByteArray curves(const std::vector<std::vector<Vec3>> &strokes);

/// A mesh a user can go on with: finite, manifold, consistently oriented, no repeated corners; empty sentence
/// if so.
QString faultOfMesh(const TriangleMesh &mesh);

/// Median distance of the strokes to the mesh in % of its diagonal against \a medianPercent.
QString faultOfFit(const StrokeSet &strokes, const TriangleMesh &mesh, double medianPercent);

/// A run that failed as it should: exit code 1, exactly one message, which contains all of \a words, and \a
/// folder as it was \a before.
QString faultOfRefusal(const ProgramRun &run, const QStringList &words, const QString &folder,
                       const QStringList &before);

} // namespace ductus
