// What one does with a finished surface: look whether it can be printed, and send it on to be painted. By
// mouse and keys on the real window, with a LayerPainter that only writes down what it was given.
#include "document/document_files.h"
#include "project/project_reader.h"
#include "sketchsurfacer/ui/testing/app_under_test.h"
#include "sketchsurfacer/ui/viewport/length_text.h"
#include "sketchsurfacer/ui/window/print_panel.h"
#include "widgets/shell/message_bar.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QtTest>

using namespace ductus;
using namespace ductus::testing;

class FinishedSurfaceTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void withoutASurfaceThereIsNothingToSend();
    void thePrintCheckSpeaksOfWalls();
    void showTurnsToThePlace();
    void aSmallerPrintHasThinnerWalls();
    void whatIsUnsavedIsAskedToBeSaved();
    void aMissingProgramIsNamed();

private:
    const PrintFinding *finding(const QString &id) const
    {
        for (const PrintFinding &finding : mApp->window->printCheck().findings())
            if (finding.id == id)
                return &finding;
        return nullptr;
    }
    bool isTold(const QString &words) const
    {
        for (const Message &message : mApp->window->messages()->messages())
            if (message.what.contains(words))
                return true;
        return false;
    }
    QPushButton *messageButton() const
    {
        for (QPushButton *button : mApp->window->messages()->findChildren<QPushButton *>())
            if (button->isVisible())
                return button;
        return nullptr;
    }

    std::unique_ptr<App> mApp;
};

void FinishedSurfaceTest::initTestCase()
{
    QStandardPaths::setTestModeEnabled(true);
    mApp = std::make_unique<App>();
    SurfacerWindow &window = *mApp->window;
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QVERIFY(mApp->open("bottle"));
    mApp->chooseQuickOptions();
}

void FinishedSurfaceTest::withoutASurfaceThereIsNothingToSend()
{
    SurfacerWindow &window = *mApp->window;
    mApp->press(Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(isTold("none yet") && messageButton());
    QTest::mouseClick(messageButton(), Qt::LeftButton); // Surface it
    QVERIFY(mApp->waitForResult());
    QVERIFY(!isTold("none yet"));
}

void FinishedSurfaceTest::thePrintCheckSpeaksOfWalls()
{
    SurfacerWindow &window = *mApp->window;
    QTRY_VERIFY_WITH_TIMEOUT(window.printCheck().check() != nullptr, 60'000);
    const PrintCheck &check = *window.printCheck().check();
    QVERIFY(check.isWatertight && check.thinnestWall && check.crossings.empty());
    const PrintFinding *watertight = finding("watertight"), *wall = finding("wall");
    QVERIFY(watertight && watertight->kind == FindingKind::Good);
    QVERIFY(wall && wall->place && wall->text.contains("mm"));
    QCOMPARE(window.printCheck().findChild<QLabel *>("wall")->text(), wall->text);
    // As it is told: the wall is where it is said to be.
    QVERIFY(std::abs((wall->place->at - *wall->place->other).norm() - check.thinnestWall->length) <
            1e-9 * check.box.diagonal());
    for (QWidget *around = &window.printCheck(); around; around = around->parentWidget())
        if (auto *area = qobject_cast<QScrollArea *>(around))
            area->ensureWidgetVisible(&window.printCheck());
    mApp->shot("print-1-panel");
}

void FinishedSurfaceTest::showTurnsToThePlace()
{
    SurfacerWindow &window = *mApp->window;
    SketchView &view = window.view();
    const ViewCamera before = view.camera();
    auto *button = window.printCheck().findChild<QPushButton *>("show-wall");
    QVERIFY(button);
    const FoundPlace place = *finding("wall")->place;
    QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(view.overlay().mark());
    const auto distance = [&] {
        const Vec3 centre = 0.5 * (place.at + *place.other);
        const QPointF at = view.camera().project(centre).value_or(QPointF(1e9, 1e9)) -
                           QPointF(0.5 * view.width(), 0.5 * view.height());
        return std::hypot(at.x(), at.y());
    };
    QTRY_VERIFY_WITH_TIMEOUT(distance() < 2.0, 20'000);
    QVERIFY(view.camera().distance() < before.distance());
    // Seen: what is hit first under the place is the place.
    const auto hit = view.surfaceAt(*view.camera().project(place.at));
    QVERIFY(hit && (hit->point - place.at).norm() < 0.01 * view.extent().diagonal());
    mApp->shot("print-2-shown");
    view.setFocus();
    mApp->press(Qt::Key_Escape);
    QVERIFY(!view.overlay().mark());
    mApp->press(Qt::Key_F);
}

void FinishedSurfaceTest::aSmallerPrintHasThinnerWalls()
{
    SurfacerWindow &window = *mApp->window;
    auto *longest = window.printCheck().findChild<QDoubleSpinBox *>("printLongest");
    auto *nozzle = window.printCheck().findChild<QDoubleSpinBox *>("printNozzle");
    QVERIFY(longest && nozzle);
    const PrintCheck &check = *window.printCheck().check();
    const double share = check.thinnestWall->length / (check.box.max - check.box.min).maxCoeff();
    const auto wallAt = [&](double millimetres) {
        longest->setValue(millimetres);
        const double metres = share * 0.001 * longest->value();
        if (!finding("wall")->text.contains(lengthText(metres, window.locale())))
            qFatal("%s", qPrintable(finding("wall")->text));
        return finding("wall")->kind;
    };
    nozzle->setValue(0.4);
    QCOMPARE(wallAt(std::ceil(1.1 * 0.8 / share)), FindingKind::Good);
    QCOMPARE(wallAt(std::round(0.6 / share)), FindingKind::Doubtful);
    nozzle->setValue(1.0);
    QCOMPARE(finding("wall")->kind, FindingKind::Bad);
    QCOMPARE(window.printCheck().findings().front().kind, FindingKind::Bad); // worst first
    nozzle->setValue(0.4);
}

void FinishedSurfaceTest::whatIsUnsavedIsAskedToBeSaved()
{
    SurfacerWindow &window = *mApp->window;
    const QString told = mApp->dir.filePath("told"), project = mApp->dir.filePath("bottle.ductus");
    QVERIFY(QDir(mApp->dir.path()).mkdir("bin"));
    QFile program(mApp->dir.filePath("bin/layerpainter"));
    QVERIFY(program.open(QIODevice::WriteOnly));
    program.write("#!/bin/sh\ncp \"$1\" '" + told.toUtf8() + ".part' && mv '" + told.toUtf8() + ".part' '" +
                  told.toUtf8() + "'\n");
    program.close();
    program.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    const QByteArray path = qgetenv("PATH");
    qputenv("PATH", mApp->dir.filePath("bin").toUtf8() + ':' + path);

    bool isSaved = false;
    {
        // As Save as would, without its dialog.
        const auto saved = saveDocument(window.sketch(), mApp->jobs, project,
                                        [&](Result<SaveReport> report) { isSaved = report.ok(); });
        QVERIFY(saved > 0);
    }
    QTRY_VERIFY_WITH_TIMEOUT(isSaved, 30'000);
    window.sketch().setUnit(0.01, UpAxis::Y);
    QVERIFY(window.sketch().isModified());
    QVERIFY(mApp->waitForResult());
    mApp->press(Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(!QFile::exists(told));
    QVERIFY(messageButton());
    mApp->shot("send-1-asked");
    QTest::mouseClick(messageButton(), Qt::LeftButton); // Save and send
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(told), 30'000);
    QVERIFY(!window.sketch().isModified());
    qputenv("PATH", path);
    // What it was given holds the surface, as it is.
    const Result<Project> given = openProject(enginePath(told), knownDocuments());
    QVERIFY2(given.ok(), given ? "" : given.error().message().c_str());
    const auto &sketch = given->documents.front().sketchSurface;
    QVERIFY(sketch && sketch->surface && sameMesh(sketch->surface->mesh, mApp->surface()));
    QCOMPARE(sketch->strokes.metresPerUnit, 0.01);
}

void FinishedSurfaceTest::aMissingProgramIsNamed()
{
    SurfacerWindow &window = *mApp->window;
    window.messages()->closeAll();
    const QByteArray path = qgetenv("PATH");
    qputenv("PATH", mApp->dir.path().toUtf8());
    mApp->press(Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier);
    qputenv("PATH", path);
    QVERIFY(isTold("layerpainter") && isTold("not installed"));
}

QTEST_MAIN(FinishedSurfaceTest)
#include "finished_surface_test.moc"
