// "I painted this in VR": other people's Quill and .tilt files become projects whose strokes are strokes, are
// looked into, drawn, and exported, all from the command line. The files stand outside the repository.
#include "formats/mesh_file.h"
#include "formats/png_file.h"
#include "journeys/program_run.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>

using namespace ductus;

class PaintRealFilesTest : public QObject
{
    Q_OBJECT
private slots:
    void becomeProjectsPicturesAndMeshes_data();
    void becomeProjectsPicturesAndMeshes();
    void halfAFileIsRefused();

private:
    static ProgramRun run(const QStringList &arguments)
    {
        return runProgram(QStringLiteral(DUCTUS_LAYERPAINTER), arguments);
    }
    static QJsonObject json(const QString &path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object()
                                              : QJsonObject();
    }
};

#define DONE(...)                                                                                            \
    do {                                                                                                     \
        const ProgramRun done = run(__VA_ARGS__);                                                            \
        QVERIFY2(done.started && !done.crashed && !done.hung && done.exitCode == 0,                          \
                 done.told().constData());                                                                   \
    } while (false)

void PaintRealFilesTest::becomeProjectsPicturesAndMeshes_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("kind");
    for (const char *file : {"quill/btparker/CBrushLine", "quill/btparker/CCBrushStroke"})
        QTest::newRow(file) << file << "quill";
    for (const char *file : {"tilt/OneStroke.tilt", "tilt/Simple.tilt", "tilt/sketch1.tilt", "tilt/Ink.tilt"})
        QTest::newRow(file) << file << "tilt";
}

void PaintRealFilesTest::becomeProjectsPicturesAndMeshes()
{
    QFETCH(QString, file);
    QFETCH(QString, kind);
    const QString in = QDir(DUCTUS_SHARED_DATA).filePath(file);
    if (!QFileInfo::exists(in))
        QSKIP("the folder with other people's paintings is not here");
    QTemporaryDir folder;
    const auto at = [&](const char *name) { return folder.filePath(QString::fromUtf8(name)); };
    const QString project = at("絵 für später.ductus");

    DONE({"import", in, "-q", "-o", project, "--report", at("report.json")});
    const QJsonObject report = json(at("report.json"));
    QVERIFY2(report["kind"].toString().contains(kind, Qt::CaseInsensitive),
             qPrintable(report["kind"].toString()));
    const int strokes = report["painting"]["strokes"].toInt();
    QVERIFY(strokes > 0);
    QCOMPARE(report["file"]["strokes"].toInt(), strokes); // none lost, none baked into a mesh
    QCOMPARE(report["painting"]["meshes"].toInt(), 0);

    DONE({"validate", project});
    const ProgramRun info = run({"info", project, "--json"});
    QCOMPARE(info.exitCode, 0);
    const QJsonObject held = QJsonDocument::fromJson(info.out.toUtf8()).object();
    QCOMPARE(held["documents"][0]["painting"]["strokes"].toInt(), strokes);
    QCOMPARE(held["documents"][0]["painting"]["points"].toInt(), report["file"]["points"].toInt());

    // From the project and from the file itself the same picture, and something is on it.
    DONE({"render", project, "-q", "-o", at("p.png"), "--size", "96x60", "--samples", "1", "--transparent"});
    DONE({"render", in, "-q", "-o", at("f.png"), "--size", "96x60", "--samples", "1", "--transparent"});
    const Result<Image> picture = readPng(at("p.png").toStdString()),
                        direct = readPng(at("f.png").toStdString());
    QVERIFY(picture.ok() && direct.ok());
    QVERIFY(picture->pixels == direct->pixels);
    int painted = 0;
    for (int y = 0; y < picture->height; ++y)
        for (int x = 0; x < picture->width; ++x)
            painted += picture->at(x, y)[3] > 0;
    QVERIFY2(painted > 30, qPrintable(QString::number(painted)));

    DONE({"thumbnail", project, "-q", "-o", at("t.png"), "--size", "64"});
    QCOMPARE(readPng(at("t.png").toStdString())->width, 64);
    DONE({"export", project, "-q", "-o", at("m.glb")});
    const Result<TriangleMesh> mesh = readMesh(at("m.glb").toStdString(), JobControl());
    QVERIFY(mesh.ok());
    QVERIFY(mesh->triangleCount() > strokes);
    QCOMPARE(namesBelow(folder.path()).size(), 6); // and no lock, no half-written file
}

void PaintRealFilesTest::halfAFileIsRefused()
{
    QFile whole(QDir(DUCTUS_SHARED_DATA).filePath("tilt/Simple.tilt"));
    if (!whole.open(QIODevice::ReadOnly))
        QSKIP("the folder with other people's paintings is not here");
    QTemporaryDir folder;
    QFile half(folder.filePath("half.tilt"));
    QVERIFY(half.open(QIODevice::WriteOnly));
    half.write(whole.read(whole.size() / 2));
    half.close();
    const ProgramRun refused = run({"import", half.fileName(), "-o", folder.filePath("p.ductus")});
    QVERIFY2(!refused.crashed && refused.exitCode == 1, refused.told().constData());
    QVERIFY2(refused.err.contains("half.tilt"), refused.told().constData());
    QCOMPARE(namesBelow(folder.path()), QStringList{QString("half.tilt")});
}

QTEST_GUILESS_MAIN(PaintRealFilesTest)
#include "paint_real_files_test.moc"
