#include "document/linked_app.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

using namespace ductus;

class LinkedAppTest : public QObject
{
    Q_OBJECT
private slots:
    void theProgramGetsTheFile();
    void whatIsMissingIsNamed();
};

void LinkedAppTest::theProgramGetsTheFile()
{
    QTemporaryDir folder;
    const QString told = folder.filePath("told"), project = folder.filePath("mein Entwurf ü.ductus");
    for (const auto &[path, text] :
         {std::pair(folder.filePath("layerpainter"),
                    QByteArray("#!/bin/sh\nprintf '%s' \"$1\" > '" + told.toUtf8() + ".part'\nmv '" +
                               told.toUtf8() + ".part' '" + told.toUtf8() + "'\n")),
          std::pair(project, QByteArray("project"))}) {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
        file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    }
    const QByteArray before = qgetenv("PATH");
    qputenv("PATH", folder.path().toUtf8() + ':' + before);
    QCOMPARE(findProgram(LinkedApp::LayerPainter), folder.filePath("layerpainter"));
    const Result<void> opened = openInApp(LinkedApp::LayerPainter, project);
    qputenv("PATH", before);
    QVERIFY2(opened.ok(), opened ? "" : opened.error().message().c_str());
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(told), 20'000);
    QFile file(told);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(QString::fromUtf8(file.readAll()), project);
}

void LinkedAppTest::whatIsMissingIsNamed()
{
    QTemporaryDir folder;
    QFile project(folder.filePath("p.ductus"));
    QVERIFY(project.open(QIODevice::WriteOnly));
    const QByteArray before = qgetenv("PATH");
    qputenv("PATH", folder.path().toUtf8());
    const Result<void> noProgram = openInApp(LinkedApp::DoodleStudio, project.fileName());
    const Result<void> noFile = openInApp(LinkedApp::DoodleStudio, folder.filePath("gone.ductus"));
    qputenv("PATH", before);
    QVERIFY(!noProgram && noProgram.error().code == ErrorCode::FileNotFound);
    QVERIFY(QString::fromStdString(noProgram.error().message()).contains("doodlestudio"));
    QVERIFY(QString::fromStdString(noProgram.error().message()).contains("not installed"));
    QVERIFY(!noFile && noFile.error().place == folder.filePath("gone.ductus").toStdString());
}

QTEST_GUILESS_MAIN(LinkedAppTest)
#include "linked_app_test.moc"
