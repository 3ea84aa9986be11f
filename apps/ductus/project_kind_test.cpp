// "I clicked on a project": the app that saved it opens.
#include "ductus/project_kind.h"

#include <QtTest>

using namespace ductus;

class ProjectKindTest : public QObject
{
    Q_OBJECT
private slots:
    void theAppThatSavedItOpens_data();
    void theAppThatSavedItOpens();
    void nothingForWhatNoAppEdits();
};

namespace {

Project projectOf(const QString &generator, const QStringList &kinds)
{
    Project project;
    project.generator = generator.toStdString();
    for (const QString &kind : kinds) {
        project.documents.emplace_back();
        project.documents.back().kind = kind.toStdString();
    }
    return project;
}

} // namespace

void ProjectKindTest::theAppThatSavedItOpens_data()
{
    QTest::addColumn<QString>("generator");
    QTest::addColumn<QStringList>("kinds");
    QTest::addColumn<QString>("program");
    const QString sketch = "sketch-surface", painting = "painting", doodle = "doodle";
    QTest::newRow("sketch") << "SketchSurfacer" << QStringList{sketch} << "sketchsurfacer";
    QTest::newRow("painting") << "LayerPainter 1.2" << QStringList{painting} << "layerpainter";
    QTest::newRow("doodle") << "DoodleStudio" << QStringList{doodle} << "doodlestudio";
    QTest::newRow("painted surface") << "LayerPainter" << QStringList{painting, sketch} << "layerpainter";
    QTest::newRow("surface of it mended")
        << "SketchSurfacer" << QStringList{sketch, painting} << "sketchsurfacer";
    QTest::newRow("saved by another program") << "Other" << QStringList{sketch, painting} << "layerpainter";
    QTest::newRow("saved by an app with nothing in it")
        << "DoodleStudio" << QStringList{sketch} << "sketchsurfacer";
}

void ProjectKindTest::theAppThatSavedItOpens()
{
    QFETCH(QString, generator);
    QFETCH(QStringList, kinds);
    QFETCH(QString, program);
    const std::optional<LinkedApp> app = appOf(projectOf(generator, kinds));
    QVERIFY(app);
    QCOMPARE(programOf(*app), program);
}

void ProjectKindTest::nothingForWhatNoAppEdits()
{
    QVERIFY(!appOf(projectOf("SketchSurfacer", {})));
    QVERIFY(!appOf(projectOf("LayerPainter", {"of-the-future"})));
}

QTEST_APPLESS_MAIN(ProjectKindTest)
#include "project_kind_test.moc"
