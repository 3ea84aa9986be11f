// What leaves LayerPainter's window and comes into it, and what moves: pictures, films, other files, the
// motion of a painting. With DUCTUS_SHOTS naming a folder each step leaves a picture there.
#include "layerpainter/ui/testing/painter_under_test.h"
#include "layerpainter/ui/window/film_dialog.h"
#include "layerpainter/ui/window/picture_dialog.h"
#include "widgets/shell/message_bar.h"

#include <QtTest>
#include <utility>

using namespace ductus;

class PainterOutputTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void exportsAPicture();
    void playsTheMotionAndKeepsViews();
    void paintsWhereTheLayerHasMovedTo();
    void exportsAFilmInTheBackground();
    void importsIntoTheOpenPainting();

private:
    std::unique_ptr<PainterUnderTest> mApp;
};

void PainterOutputTest::initTestCase()
{
    QStandardPaths::setTestModeEnabled(true);
    mApp = std::make_unique<PainterUnderTest>();
    QVERIFY(QTest::qWaitForWindowExposed(mApp->window.get()));
    mApp->window->newPainting();
    const QPoint middle = mApp->window->view().rect().center();
    for (int i = 0; i < 3; ++i)
        mApp->drag({middle + QPoint(-200, 60 * i - 60), middle + QPoint(0, 60 * i - 90),
                    middle + QPoint(200, 60 * i - 60)});
    QCOMPARE(mApp->strokes(mApp->window->layers().tree().currentLayer()), 3);
}

void PainterOutputTest::exportsAPicture()
{
    const QString path = mApp->folder.filePath("p.png");
    FrameOptions options;
    options.width = 320;
    options.height = 200;
    options.transparentBackground = true;
    mApp->window->exportPicture(path, options);
    QVERIFY(mApp->jobs.waitForAll(120'000));
    const QImage picture(path);
    QCOMPARE(picture.size(), QSize(320, 200));
    bool isClear = false, isPainted = false;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            isClear |= qAlpha(picture.pixel(x, y)) == 0;
            isPainted |= qAlpha(picture.pixel(x, y)) == 255;
        }
    QVERIFY(isPainted);
    QVERIFY(isClear);
    PictureDialog dialog(mApp->window->view().size());
    dialog.show();
    QCOMPARE(dialog.choice().width, 2 * mApp->window->view().width());
    if (const QString to = qEnvironmentVariable("DUCTUS_SHOTS"); !to.isEmpty())
        dialog.grab().save(to + "/07-picture.png");
    dialog.close();
    for (const char *sample : {"forest-path", "plane-over-clouds"}) {
        mApp->window->painting().reset();
        QVERIFY(mApp->open(QLatin1String(sample)));
        mApp->shot(QStringLiteral("07-") + sample);
    }
}

void PainterOutputTest::playsTheMotionAndKeepsViews()
{
    PainterWindow &window = *mApp->window; // the plane over clouds
    PaintingView &view = window.view();
    QVERIFY(window.motion().isVisible());
    QCOMPARE(view.seconds(), 0.0);
    // The timeline has just come and the canvas gives way to it: not before it has is there a picture to
    // return to.
    QSize size;
    QVERIFY(QTest::qWaitFor(
        [&] {
            const QSize last = std::exchange(size, view.size());
            return last == size;
        },
        5'000));
    const QImage start = view.picture();
    mApp->press(Qt::Key_Space);
    QVERIFY(window.motion().isPlaying());
    QVERIFY(QTest::qWaitFor([&] { return view.seconds() > 0.4; }, 20'000));
    mApp->press(Qt::Key_Space);
    QVERIFY(!window.motion().isPlaying());
    QVERIFY(view.picture() != start);
    mApp->shot("08-playing");
    const std::size_t keys = window.painting().painting().camera.keys.size();
    window.motion().setSeconds(0.5);
    mApp->press(Qt::Key_K);
    const auto &path = window.painting().painting().camera.keys;
    QCOMPARE(path.size(), keys + 1);
    QVERIFY(std::ranges::is_sorted(path, {}, &CameraKey::timeSeconds));
    window.motion().removeKey();
    QCOMPARE(window.painting().painting().camera.keys.size(), keys);
    window.motion().setSeconds(0);
    QCOMPARE(view.picture(), start);
}

// "I stopped the motion, painted on the plane, and the stroke was elsewhere."
void PainterOutputTest::paintsWhereTheLayerHasMovedTo()
{
    PainterWindow &window = *mApp->window;
    PaintingView &view = window.view();
    const auto plane =
        std::ranges::find(window.painting().painting().stacks, std::string("Plane"), &Stack::name);
    const LayerId layer = plane->substrate->id;
    PlacementKey from, to;
    to.timeSeconds = 2;
    to.placement.translation = Vec3(0, 3, 0);
    to.placement.rotation = Eigen::AngleAxisd(0.7, Vec3::UnitY());
    QVERIFY(window.painting().perform(act::SetLayerMotion{layer, {from, to}}));
    window.layers().tree().choose(layer);
    window.motion().setSeconds(2);
    mApp->press(Qt::Key_B);
    QTest::qWait(200); // the timeline takes its room, with a row for the layer
    const QPoint middle = view.rect().center();
    mApp->drag({middle, middle + QPoint(30, 5), middle + QPoint(60, 10)});
    const Layer *painted = window.painting().painting().findLayer(layer);
    const auto shown = view.shownElements(*painted);
    const auto &[element, place] = shown.back();
    const auto &points = std::get<StrokeShape>(*element->shape).points;
    const auto begin = view.camera().project(place * points.front().position.cast<double>());
    QVERIFY2(
        begin && QLineF(*begin, middle).length() < 3,
        qPrintable(
            begin
                ? QString("%1 %2, not %3 %4").arg(begin->x()).arg(begin->y()).arg(middle.x()).arg(middle.y())
                : QString("behind")));
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    mApp->press(Qt::Key_Z, Qt::ControlModifier);
    window.motion().setSeconds(0);
    mApp->press(Qt::Key_O);
}

void PainterOutputTest::exportsAFilmInTheBackground()
{
    PainterWindow &window = *mApp->window;
    FilmDialog dialog(window.painting().sharedPainting(), window.view().camera().key(), &window);
    dialog.show();
    if (const QString to = qEnvironmentVariable("DUCTUS_SHOTS"); !to.isEmpty())
        dialog.grab().save(to + "/09-film.png");
    FilmChoice choice = dialog.choice();
    QVERIFY(choice.film.plan.frames > 1);
    choice.film.plan.frames = 3;
    choice.film.frames.width = 96;
    choice.film.frames.height = 54;
    const QString path = mApp->folder.filePath("film.webm");
    window.exportFilm(path, choice);
    QVERIFY(mApp->jobs.isBusy());
    QVERIFY(mApp->jobs.waitForAll(120'000));
    QVERIFY2(QFileInfo(path).size() > 300, "no film");
    QVERIFY(window.messages()->messages().last().what.contains("film.webm"));
    // A cancelled one leaves nothing.
    choice.film.plan.frames = 100'000;
    const QString never = mApp->folder.filePath("never.mp4");
    window.exportFilm(never, choice);
    mApp->jobs.cancelAll();
    QVERIFY(mApp->jobs.waitForAll(60'000));
    QVERIFY(QDir(mApp->folder.path()).entryList({"*never*"}, QDir::Files | QDir::Hidden).isEmpty());
}

void PainterOutputTest::importsIntoTheOpenPainting()
{
    PainterWindow &window = *mApp->window;
    const std::string before = mApp->print();
    const std::size_t stacks = window.painting().painting().stacks.size();
    const QString path = mApp->folder.filePath("corner.obj");
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\n");
    file.close();
    emit window.filesDropped({path});
    QVERIFY(mApp->jobs.waitForAll(20'000));
    QCOMPARE(window.painting().painting().stacks.size(), stacks + 1);
    QCOMPARE(window.painting().painting().stacks.back().name, std::string("corner"));
    mApp->press(Qt::Key_Z, Qt::ControlModifier); // one step
    QCOMPARE(mApp->print(), before);
}

QTEST_MAIN(PainterOutputTest)
#include "painter_output_test.moc"
