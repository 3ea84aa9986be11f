// thumbnail as a file manager starts it: the sketch is in the picture, and refusals leave nothing.
#include "sketchsurfacer/cli/thumbnail_command.h"

#include "document/document_files.h"
#include "formats/png_file.h"
#include "project/saving/project_save.h"
#include "project/testing/sample_project.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace ductus;

class ThumbnailCommandTest : public QObject
{
    Q_OBJECT
private slots:
    void drawsTheSketch();
    void refusesWhatHoldsNone();

private:
    QString file(const QString &name) const { return mFolder.filePath(name); }
    QTemporaryDir mFolder;
};

void ThumbnailCommandTest::drawsTheSketch()
{
    QVERIFY(saveProject(sampleProject(5), enginePath(file("p.ductus"))).ok());
    QCOMPARE(int(runThumbnailCommand({file("p.ductus"), "-q", "-o", file("p.png"), "--size", "120"})), 0);
    const Result<Image> image = readPng(enginePath(file("p.png")));
    QVERIFY(image.ok());
    QCOMPARE(image->width, 120);
    QCOMPARE(image->height, 90);
    int dark = 0; // strokes
    for (std::size_t i = 0; i < image->pixels.size(); i += 4)
        dark += image->pixels[i] < 120;
    QVERIFY2(dark > 40, qPrintable(QString::number(dark)));
}

void ThumbnailCommandTest::refusesWhatHoldsNone()
{
    Project empty = sampleProject(5);
    empty.documents.clear();
    QVERIFY(saveProject(empty, enginePath(file("e.ductus"))).ok());
    QCOMPARE(int(runThumbnailCommand({file("e.ductus"), "-q", "-o", file("e.png")})), 1);
    QCOMPARE(int(runThumbnailCommand({file("none.ductus"), "-q", "-o", file("e.png")})), 1);
    QCOMPARE(int(runThumbnailCommand({file("p.ductus"), "-q", "-o", file("e.jpg")})), 2);
    QVERIFY(!QFile::exists(file("e.png")) && !QFile::exists(file("e.jpg")));
}

QTEST_GUILESS_MAIN(ThumbnailCommandTest)
#include "thumbnail_command_test.moc"
