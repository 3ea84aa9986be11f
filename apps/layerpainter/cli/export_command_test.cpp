// "I publish my painting where people turn it with the mouse": export, read back, look by look.
#include "layerpainter/cli/export_command.h"

#include "document/document_files.h"
#include "formats/mesh_file.h"
#include "layerpainter/document/import_file.h"
#include "layerpainter/document/painting_project.h"
#include "painting/edit/element_edits.h"
#include "painting/edit/layer_edits.h"
#include "painting/edit/look_edits.h"
#include "painting/testing/sample_painting.h"
#include "project/project_writer.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace ductus;

namespace {

/// A red tube along x with a layer that makes its right half blue in the look "blue".
Painting twoLooks()
{
    AddedStack stack = *addStack({}, "Tube");
    StrokeShape tube;
    for (const float x : {-1.f, 0.f, 1.f})
        tube.points.push_back({{x, 0, 0}, {0, 1, 0}, 0.1f, {1, 0, 0}, 1});
    Painting painting =
        addElements(stack.painting, stack.substrate, {std::make_shared<const ElementShape>(tube)})->painting;
    AddedLayer layer = *addAppearanceLayer(painting, stack.stack, "Cold");
    StrokeShape ball;
    ball.points.push_back({{1, 0, 0}, {0, 1, 0}, 0.6f, {0, 0, 1}, 1});
    painting =
        addElements(layer.painting, layer.layer, {std::make_shared<const ElementShape>(ball)})->painting;
    painting.metresPerUnit = 0.5;
    painting = addLook(painting, "Blue").painting;
    LayerProperties hidden = painting.findLayer(layer.layer)->properties;
    hidden.visible = false;
    return *setLayerProperties(painting, layer.layer, hidden);
}

} // namespace

class ExportCommandTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void looksAreBaked();
    void theSameBytesEachTime();
    void comesBackWithItsColours();
    void refusesInWords_data();
    void refusesInWords();

private:
    QString file(const QString &name) const { return mFolder.filePath(name); }
    int run(const QStringList &arguments) const { return int(runExportCommand(arguments)); }
    ColouredMesh mesh(const QString &name) const { return *readColouredMesh(enginePath(file(name)), {}); }

    QTemporaryDir mFolder;
};

void ExportCommandTest::initTestCase()
{
    QVERIFY(mFolder.isValid());
    const Result<SerializedProject> project = serializedProject(projectOf(twoLooks(), "Tube"));
    QVERIFY(project.ok());
    QFile out(file("p.ductus"));
    QVERIFY(out.open(QIODevice::WriteOnly));
    out.write(reinterpret_cast<const char *>(project->bytes.data()), qint64(project->bytes.size()));
}

void ExportCommandTest::looksAreBaked()
{
    QCOMPARE(run({file("p.ductus"), "-q", "-o", file("plain.glb"), "--edge", "0.05"}), 0);
    QCOMPARE(run({file("p.ductus"), "-q", "-o", file("blue.glb"), "--edge", "0.05", "--look", "blue"}), 0);
    const ColouredMesh plain = mesh("plain.glb"), blue = mesh("blue.glb");
    QVERIFY(plain.mesh.vertexCount() > 200);
    QCOMPARE(plain.vertexColours.size(), plain.mesh.vertices.size());
    for (const Eigen::Vector4f &colour : plain.vertexColours)
        QVERIFY((colour - Eigen::Vector4f(1, 0, 0, 1)).norm() < 1e-3f);
    int reds = 0, blues = 0;
    for (std::size_t v = 0; v < blue.mesh.vertices.size(); ++v) {
        const Vec3 units = blue.mesh.vertices[v] / 0.5; // metres in the file
        const double distance = (units - Vec3(1, 0, 0)).norm();
        if (std::abs(distance - 0.6) < 1e-3)
            continue;
        const Eigen::Vector4f expected =
            distance < 0.6 ? Eigen::Vector4f(0, 0, 1, 1) : Eigen::Vector4f(1, 0, 0, 1);
        QVERIFY((blue.vertexColours[v] - expected).norm() < 1e-3f);
        ++(distance < 0.6 ? blues : reds);
    }
    QVERIFY(reds > 50 && blues > 50);
    // Finer edges, more vertices.
    QCOMPARE(run({file("p.ductus"), "-q", "-o", file("fine.glb"), "--edge", "0.02"}), 0);
    QVERIFY(mesh("fine.glb").mesh.vertexCount() > 2 * plain.mesh.vertexCount());
}

void ExportCommandTest::theSameBytesEachTime()
{
    for (const char *name : {"a.glb", "b.glb"})
        QCOMPARE(run({file("p.ductus"), "-q", "-o", file(name)}), 0);
    QFile a(file("a.glb")), b(file("b.glb"));
    QVERIFY(a.open(QIODevice::ReadOnly) && b.open(QIODevice::ReadOnly));
    QVERIFY(a.size() > 1000);
    QCOMPARE(a.readAll(), b.readAll());
}

void ExportCommandTest::comesBackWithItsColours()
{
    QCOMPARE(run({file("p.ductus"), "-q", "-o", file("back.glb"), "--look", "Blue"}), 0);
    const Result<ImportedFile> back = importFile(enginePath(file("back.glb")), {}, {});
    QVERIFY(back.ok());
    const auto &shape =
        std::get<MeshShape>(*back->painting.stacks[0].substrate->drawings[0].elements[0].shape);
    const auto isBlue = [](const Eigen::Vector3f &c) { return c.z() > 0.99f && c.x() < 0.01f; };
    QVERIFY(std::ranges::any_of(shape.vertexColours, isBlue));
    QVERIFY(!std::ranges::all_of(shape.vertexColours, isBlue));
    QVERIFY(back->notes.empty());
}

void ExportCommandTest::refusesInWords_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("code");
    QTest::newRow("nothing") << QStringList{} << 2;
    QTest::newRow("no output") << QStringList{"p.ductus"} << 2;
    QTest::newRow("another format") << QStringList{"p.ductus", "-o", "x.obj"} << 2;
    QTest::newRow("no length") << QStringList{"p.ductus", "-o", "x.glb", "--edge", "0"} << 2;
    QTest::newRow("no number") << QStringList{"p.ductus", "-o", "x.glb", "--edge", "fine"} << 2;
    QTest::newRow("no such look") << QStringList{"p.ductus", "-o", "x.glb", "--look", "dawn"} << 1;
    QTest::newRow("no such file") << QStringList{"none.ductus", "-o", "x.glb"} << 1;
}

void ExportCommandTest::refusesInWords()
{
    QFETCH(QStringList, arguments);
    QFETCH(int, code);
    const QString before = QDir::currentPath();
    QDir::setCurrent(mFolder.path());
    const int found = run(arguments);
    QDir::setCurrent(before);
    QCOMPARE(found, code);
    QVERIFY(!QFile::exists(file("x.glb")));
}

QTEST_GUILESS_MAIN(ExportCommandTest)
#include "export_command_test.moc"
