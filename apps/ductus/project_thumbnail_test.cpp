// What a file manager asks for: the picture a project was saved with, at its size, whichever app it is of;
// without one the app draws it, and where that is impossible it is said.
#include "ductus/project_thumbnail.h"

#include "document/document_files.h"
#include "document/project_picture.h"
#include "project/project_reader.h"
#include "project/saving/project_save.h"
#include "project/testing/sample_project.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace ductus;

class ProjectThumbnailTest : public QObject
{
    Q_OBJECT
private slots:
    void takesThePictureInTheContainer_data();
    void takesThePictureInTheContainer();
    void asksTheAppWhereThereIsNone();
    void saysWhoCannotDrawIt();
    void refusesWhatIsNoProject();

private:
    QString saved(const Project &project) const
    {
        const QString path = mFolder.filePath(QStringLiteral("p r\u00f6.ductus"));
        return saveProject(project, enginePath(path)).ok() ? path : QString();
    }
    QTemporaryDir mFolder;
};

void ProjectThumbnailTest::takesThePictureInTheContainer_data()
{
    QTest::addColumn<int>("size");
    QTest::addColumn<QSize>("expected");
    QTest::newRow("as it is") << 256 << QSize(200, 100);
    QTest::newRow("never larger") << 512 << QSize(200, 100);
    QTest::newRow("smaller") << 64 << QSize(64, 32);
}

void ProjectThumbnailTest::takesThePictureInTheContainer()
{
    QFETCH(int, size);
    QFETCH(QSize, expected);
    QImage picture(200, 100, QImage::Format_ARGB32);
    picture.fill(QColor(10, 200, 30, 128));
    Project project = sampleProject(3);
    setProjectThumbnail(project, picture);
    const Result<Image> image = thumbnailOf(enginePath(saved(project)), size, {});
    QVERIFY2(image.ok(), image ? "" : image.error().message().c_str());
    QCOMPARE(QSize(image->width, image->height), expected);
    const Rgba middle = image->at(image->width / 2, image->height / 2);
    const Rgba filled{10, 200, 30, 128};
    for (int channel = 0; channel < 4; ++channel) // unpremultiplied: off by one when scaled
        QVERIFY(std::abs(int(middle[channel]) - int(filled[channel])) <= 1);
}

void ProjectThumbnailTest::asksTheAppWhereThereIsNone()
{
    // A program of the app's name in PATH, as none stands beside this test.
    const QString folder = mFolder.filePath(QStringLiteral("bin"));
    QVERIFY(QDir().mkpath(folder));
    const QString log = mFolder.filePath(QStringLiteral("asked"));
    QFile script(folder + QStringLiteral("/sketchsurfacer"));
    QVERIFY(script.open(QIODevice::WriteOnly));
    script.write("#!/bin/sh\necho \"$@\" > '" + log.toUtf8() + "'\necho 'no such command' >&2\nexit 2\n");
    script.close();
    script.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    const QByteArray before = qgetenv("PATH");
    qputenv("PATH", QFile::encodeName(folder) + ":" + before);
    Project project = sampleProject(3);
    setProjectThumbnail(project, {});
    project.generator = "SketchSurfacer";
    const QString path = saved(project);
    const Result<Image> image = thumbnailOf(enginePath(path), 77, {});
    qputenv("PATH", before);
    QFile asked(log);
    QVERIFY(asked.open(QIODevice::ReadOnly));
    const QString words = QString::fromUtf8(asked.readAll());
    QVERIFY2(words.startsWith("thumbnail " + path + " -o ") && words.contains("--size 77"),
             qPrintable(words));
    QVERIFY(!image);
    QVERIFY(image.error().problem.find("no such command") != std::string::npos);
}

void ProjectThumbnailTest::saysWhoCannotDrawIt()
{
    Project project = sampleProject(3);
    setProjectThumbnail(project, {});
    project.documents.clear();
    const Result<Image> image = thumbnailOf(enginePath(saved(project)), 64, {});
    QVERIFY(!image);
    QCOMPARE(image.error().code, ErrorCode::Unsupported);
}

void ProjectThumbnailTest::refusesWhatIsNoProject()
{
    QVERIFY(!thumbnailOf(enginePath(mFolder.filePath(QStringLiteral("none.ductus"))), 64, {}));
    QFile text(mFolder.filePath(QStringLiteral("text.ductus")));
    QVERIFY(text.open(QIODevice::WriteOnly));
    text.write("not a project");
    text.close();
    const Result<Image> image = thumbnailOf(enginePath(text.fileName()), 64, {});
    QVERIFY(!image);
    QCOMPARE(image.error().code, ErrorCode::Malformed);
}

QTEST_GUILESS_MAIN(ProjectThumbnailTest)
#include "project_thumbnail_test.moc"
