#include "journeys/sketch_journey.h"

#include "formats/mesh_file.h"
#include "formats/sketch_file.h"
#include "geometry/mesh_topology.h"
#include "support/evaluation.h"
#include "support/sample_sketches.h"

#include <QFile>

namespace ductus {

QString samplePath(const QString &id)
{
    return QStringLiteral(DUCTUS_SOURCE_DIR "/resources/samples/%1.curves").arg(id);
}

QStringList surfaceArguments(const QString &in, const QString &out, const QStringList &more)
{
    QStringList arguments = {QStringLiteral("surface"), in, QStringLiteral("-o"), out};
    if (!more.contains(QStringLiteral("--proxy-vertices")))
        arguments += {QStringLiteral("--proxy-vertices"), QStringLiteral("2500")};
    return arguments + more;
}

QByteArray bytesOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

bool writeBytes(const QString &path, const QByteArray &bytes)
{
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.flush();
}

TriangleMesh meshOf(const QString &path)
{
    Result<TriangleMesh> mesh = readMesh(std::filesystem::path(path.toStdU16String()), {});
    if (!mesh)
        qFatal("%s", mesh.error().message().c_str());
    return std::move(*mesh);
}

StrokeSet strokesOf(const QString &path)
{
    Result<SketchFile> sketch = readSketch(std::filesystem::path(path.toStdU16String()), {}, {});
    if (!sketch)
        qFatal("%s", sketch.error().message().c_str());
    return std::move(sketch->strokes);
}

QByteArray curves(const std::vector<std::vector<Vec3>> &strokes)
{
    QByteArray text;
    for (const std::vector<Vec3> &stroke : strokes) {
        text += "v " + QByteArray::number(qlonglong(stroke.size())) + "\n";
        for (const Vec3 &p : stroke)
            text += QByteArray::number(p.x(), 'g', 17) + " " + QByteArray::number(p.y(), 'g', 17) + " " +
                    QByteArray::number(p.z(), 'g', 17) + "\n";
    }
    return text;
}

QString faultOfMesh(const TriangleMesh &mesh)
{
    if (mesh.isEmpty())
        return QStringLiteral("the mesh is empty");
    for (const Vec3 &v : mesh.vertices)
        if (!v.allFinite())
            return QStringLiteral("a vertex is not finite");
    const ManifoldReport report = manifoldReport(mesh);
    if (!report.isManifold())
        return QStringLiteral(
                   "not a manifold: %1 edges with more than two triangles, %2 edges with triangles that "
                   "disagree on the outside, %3 vertices with more than one fan")
            .arg(report.nonManifoldEdges)
            .arg(report.inconsistentEdges)
            .arg(report.nonManifoldVertices);
    if (report.isClosed() && signedVolume(mesh) <= 0.0)
        return QStringLiteral("closed, but inside out");
    return {};
}

QString faultOfFit(const StrokeSet &strokes, const TriangleMesh &mesh, double medianPercent)
{
    const Result<DeviationStatistics> deviation = strokeDeviation(strokes, mesh);
    if (!deviation)
        return QString::fromStdString(deviation.error().message());
    if (!(deviation->median <= medianPercent))
        return QStringLiteral("half of the strokes is farther than %1 % of the diagonal from the surface")
            .arg(deviation->median);
    return {};
}

QString faultOfRefusal(const ProgramRun &run, const QStringList &words, const QString &folder,
                       const QStringList &before)
{
    if (run.crashed || run.hung || run.exitCode != 1)
        return QStringLiteral("it should have ended with exit code 1");
    const QStringList messages = run.messages();
    if (messages.size() != 1)
        return QStringLiteral("%1 messages instead of one").arg(messages.size());
    for (const QString &word : words)
        if (!messages.first().contains(word, Qt::CaseInsensitive))
            return QStringLiteral("the message does not say \"%1\"").arg(word);
    if (!run.out.isEmpty())
        return QStringLiteral("stdout is not empty");
    const QStringList after = namesBelow(folder);
    if (after != before)
        return QStringLiteral("the folder held [%1] and now holds [%2]")
            .arg(before.join(QStringLiteral(", ")), after.join(QStringLiteral(", ")));
    return {};
}

} // namespace ductus
