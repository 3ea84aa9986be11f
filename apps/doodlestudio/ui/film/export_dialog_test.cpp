// The export dialog by mouse: presets, a file that is there already, cancelling, errors in place, the folder.
#include "doodlestudio/ui/film/export_dialog.h"
#include "doodlestudio/ui/testing/studio_under_test.h"
#include "support/clip_scenes.h"

#include <QCheckBox>
#include <QDesktopServices>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>

using namespace ductus;

class UrlCatcher : public QObject
{
    Q_OBJECT
public:
    QUrl url;
public slots:
    void open(const QUrl &opened) { url = opened; }
};

class ExportDialogTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void presetsChooseTheKindOfFile();
    void cancellingLeavesWhatWasThere();
    void whatIsThereIsReplacedOnlyWhenAgreed();
    void errorsAreSaidInTheDialog();
    void overlayIsSeeThrough();
    void theFolderIsShown();
    void cleanupTestCase() { mApp.reset(); }

private:
    QPushButton *button(const char *name) const { return mDialog->findChild<QPushButton *>(name); }
    void click(const char *name) const { QTest::mouseClick(button(name), Qt::LeftButton); }
    QString status() const
    {
        const auto *label = mDialog->findChild<QLabel *>("exportStatus");
        return label->isVisible() ? label->text() : QString();
    }
    void choose(int preset) const
    {
        QTest::mouseClick(mDialog->findChildren<QRadioButton *>()[preset], Qt::LeftButton, {}, {10, 10});
    }
    bool exports()
    {
        QSignalSpy exported(mDialog, &ExportDialog::exported);
        click("startExport");
        return exported.wait(60'000);
    }
    QByteArray bytes(const QString &path) const
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    std::unique_ptr<StudioUnderTest> mApp;
    ExportDialog *mDialog = nullptr;
};

void ExportDialogTest::initTestCase()
{
    mApp = std::make_unique<StudioUnderTest>();
    QVERIFY(QTest::qWaitForWindowExposed(mApp->window.get()));
    std::vector<Image> frames;
    const ClipScene scene = tripodScene(96, 54, 6);
    for (int t = 0; t < scene.frameCount; ++t)
        frames.push_back(renderedImage(scene, t));
    const QString clip = mApp->folder.filePath("clip.mp4");
    writeClip(frames, clip, 12.0);
    QVERIFY(mApp->open(clip));
    mApp->jobs.cancelKey("analyse");
    QVERIFY(mApp->jobs.waitForAll(60'000));
    mApp->press(Qt::Key_3);
    mApp->dragOnPicture({{20, 20}, {40, 25}, {60, 30}}); // a canvas with a line
    QCOMPARE(mApp->window->doodle().scene().canvases.size(), std::size_t(1));
    mApp->press(Qt::Key_E, Qt::ControlModifier);
    mDialog = mApp->window->findChild<ExportDialog *>();
    QVERIFY(mDialog && QTest::qWaitForWindowExposed(mDialog));
}

void ExportDialogTest::presetsChooseTheKindOfFile()
{
    auto *sound = mDialog->findChild<QCheckBox *>("withSound");
    QCOMPARE(mDialog->path(), mApp->folder.filePath("clip with drawings.mp4"));
    QVERIFY(sound->isEnabled());
    choose(1);
    QVERIFY(mDialog->path().endsWith("clip with drawings.gif"));
    QVERIFY(!sound->isEnabled());
    choose(2);
    QVERIFY(mDialog->path().endsWith("clip with drawings.webm"));
    choose(0);
    QVERIFY(sound->isEnabled());
}

void ExportDialogTest::cancellingLeavesWhatWasThere()
{
    const QString path = mApp->folder.filePath("cancelled.mp4");
    mDialog->setPath(path);
    click("startExport");
    QVERIFY(mDialog->isExporting());
    QCOMPARE(button("startExport")->text(), QStringLiteral("Cancel"));
    click("startExport");
    QVERIFY(QTest::qWaitFor([&] { return !mDialog->isExporting(); }, 60'000));
    if (QFileInfo::exists(path)) { // the cancel came too late, which is said
        QVERIFY2(status().startsWith("Done: cancelled.mp4"), qPrintable(status()));
        QVERIFY(QFile::remove(path));
        return;
    }
    QCOMPARE(status(), QStringLiteral("Cancelled; nothing was written."));
    QVERIFY(QDir(mApp->folder.path()).entryList({"*cancelled*"}, QDir::Files | QDir::Hidden).isEmpty());
    QVERIFY(!button("showInFolder")->isVisible());
}

void ExportDialogTest::whatIsThereIsReplacedOnlyWhenAgreed()
{
    const QString path = mApp->folder.filePath("holiday.mp4");
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("precious") == 8);
    file.close();
    mDialog->setPath(path);
    click("startExport");
    QVERIFY(!mDialog->isExporting());
    QVERIFY2(status().contains("holiday.mp4"), qPrintable(status()));
    QCOMPARE(button("startExport")->text(), QStringLiteral("Replace"));
    QCOMPARE(bytes(path), QByteArray("precious"));
    // Another name needs no leave.
    mDialog->setPath(mApp->folder.filePath("other.mp4"));
    QCOMPARE(button("startExport")->text(), QStringLiteral("Export"));
    QVERIFY(status().isEmpty());
    mDialog->setPath(path);
    click("startExport");
    QVERIFY(exports());
    QVERIFY(bytes(path).size() > 500);
    QVERIFY(bytes(path).mid(4, 4) == "ftyp");
}

void ExportDialogTest::errorsAreSaidInTheDialog()
{
    mDialog->setPath(mApp->folder.filePath("no such folder/film.mp4"));
    click("startExport");
    QVERIFY(QTest::qWaitFor([&] { return !mDialog->isExporting(); }, 60'000));
    QVERIFY2(status().startsWith("It could not be exported:"), qPrintable(status()));
    QVERIFY(!QFileInfo::exists(mApp->folder.filePath("no such folder")));
    QCOMPARE(button("startExport")->text(), QStringLiteral("Export"));
}

void ExportDialogTest::overlayIsSeeThrough()
{
    choose(2);
    mDialog->setPath(mApp->folder.filePath("overlay.webm"));
    QVERIFY(exports());
    const Result<std::unique_ptr<Clip>> film =
        openClip(mApp->folder.filePath("overlay.webm").toStdString(), {});
    QVERIFY2(film.ok(), film ? "" : film.error().message().c_str());
    QCOMPARE((*film)->info().frameCount, 6);
    // Matroska's AlphaMode: 1.
    QVERIFY(bytes(mApp->folder.filePath("overlay.webm")).contains(QByteArray::fromHex("53c08101")));
    choose(0);
}

void ExportDialogTest::theFolderIsShown()
{
    mDialog->setPath(mApp->folder.filePath("film.mp4"));
    QVERIFY(exports());
    QVERIFY2(status().startsWith("Done: film.mp4 (96 x 54"), qPrintable(status()));
    QVERIFY(button("showInFolder")->isVisible());
    UrlCatcher catcher;
    QDesktopServices::setUrlHandler("file", &catcher, "open");
    click("showInFolder");
    QDesktopServices::unsetUrlHandler("file");
    QCOMPARE(catcher.url.toLocalFile(), mApp->folder.path());
}

int main(int argc, char *argv[])
{
    QStandardPaths::setTestModeEnabled(true);
    QLocale::setDefault(QLocale::c());
    QApplication application(argc, argv);
    ExportDialogTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "export_dialog_test.moc"
