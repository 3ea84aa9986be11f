// What the panels beside the picture do: a picture put on a canvas, the way between two pins, how it turns.
#include "doodlestudio/ui/canvases/canvas_panel.h"
#include "doodlestudio/ui/testing/studio_under_test.h"
#include "support/clip_scenes.h"

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>

using namespace ductus;

class PanelsTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void theWayBetweenTwoPinsCanBeStraight();
    void threeWaysOfTurning();
    void aPictureIsPutOnTheCanvas();
    void whatIsNoPictureIsRefused();
    void cleanupTestCase() { mApp.reset(); }

private:
    const Canvas &canvas() const { return mApp->window->doodle().scene().canvases.back(); }
    void undo() const { mApp->window->doodle().undoStack()->undo(); }
    std::unique_ptr<StudioUnderTest> mApp;
};

void PanelsTest::initTestCase()
{
    mApp = std::make_unique<StudioUnderTest>();
    QVERIFY(QTest::qWaitForWindowExposed(mApp->window.get()));
    const ClipScene scene = tripodScene(96, 54, 8);
    std::vector<Image> frames;
    for (int t = 0; t < scene.frameCount; ++t)
        frames.push_back(renderedImage(scene, t));
    const QString clip = mApp->folder.filePath("clip.mp4");
    writeClip(frames, clip, 12.0);
    QVERIFY(mApp->open(clip));
    mApp->jobs.cancelKey("analyse");
    QVERIFY(mApp->jobs.waitForAll(60'000));
    mApp->window->doodle().setShot(std::make_shared<const Shot>(trueShot(scene)));
    mApp->dragOnPicture({{20, 10}, {30, 20}, {50, 30}});
    QCOMPARE(mApp->window->doodle().scene().canvases.size(), std::size_t(1));
    mApp->window->canvasPanel().pinHere();
    mApp->window->playback().setFrame(6);
    QVERIFY(mApp->followed());
    mApp->window->canvasPanel().pinHere();
    QVERIFY(mApp->followed());
    QCOMPARE(canvas().keyframes.positions.size(), std::size_t(2));
}

void PanelsTest::theWayBetweenTwoPinsCanBeStraight()
{
    auto *straight = mApp->window->findChild<QCheckBox *>("straight");
    QVERIFY(straight && straight->isVisible());
    QVERIFY(!straight->isEnabled()); // after the last pin there is no way
    mApp->window->playback().setFrame(3);
    QVERIFY(straight->isEnabled() && !straight->isChecked());
    straight->click();
    QVERIFY(canvas().keyframes.positions[0].interpolatesNext);
    QVERIFY(!canvas().keyframes.positions[1].interpolatesNext);
    QVERIFY(straight->isChecked());
    undo();
    QVERIFY(!canvas().keyframes.positions[0].interpolatesNext && !straight->isChecked());
}

void PanelsTest::threeWaysOfTurning()
{
    auto *turning = mApp->window->findChild<QComboBox *>("turning");
    QVERIFY(turning && turning->isVisible());
    QCOMPARE(turning->count(), 3);
    const CanvasTurning before = canvas().turning;
    QCOMPARE(turning->currentIndex(), int(before));
    turning->setFocus();
    QTest::keyClick(turning, Qt::Key_Down); // End is the last frame, here too
    QTest::keyClick(turning, Qt::Key_Down);
    QVERIFY(canvas().turning == CanvasTurning::WithThing);
    undo();
    undo();
    QVERIFY(canvas().turning == before);
    QCOMPARE(turning->currentIndex(), int(before));
}

void PanelsTest::aPictureIsPutOnTheCanvas()
{
    QImage large(2048, 512, QImage::Format_RGB32);
    large.fill(QColor(10, 200, 30));
    large.setPixelColor(0, 0, Qt::red);
    const QString path = mApp->folder.filePath("flag.png");
    QVERIFY(large.save(path));
    QVERIFY(mApp->window->drawing().insertPicture(path));
    const auto &mark = std::get<PictureMark>(*canvas().doodle.frames[0].marks.back());
    QCOMPARE(QSize(mark.image->width, mark.image->height), QSize(1024, 256)); // memory is bounded
    QCOMPARE(mark.image->at(500, 200), Rgba({10, 200, 30, 255}));
    QVERIFY(std::abs(mark.size.x() / mark.size.y() - 4.0) < 0.05);
    QVERIFY(mark.size.x() <= canvas().size.x() && mark.size.y() <= canvas().size.y());
    QVERIFY(mApp->window->state().brush().tool == DrawingTool::Move);
    undo();
    QVERIFY(canvas().doodle.frames[0].marks.empty());
}

void PanelsTest::whatIsNoPictureIsRefused()
{
    QFile file(mApp->folder.filePath("words.png"));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("no picture") > 0);
    file.close();
    QSignalSpy refused(&mApp->window->doodle(), &DoodleDocument::refused);
    QVERIFY(!mApp->window->drawing().insertPicture(file.fileName()));
    QCOMPARE(refused.size(), 1);
    QVERIFY(canvas().doodle.frames[0].marks.empty());
}

int main(int argc, char *argv[])
{
    QStandardPaths::setTestModeEnabled(true);
    QLocale::setDefault(QLocale::c());
    QApplication application(argc, argv);
    PanelsTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "panels_test.moc"
