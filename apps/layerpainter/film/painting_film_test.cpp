// Films are read back frame by frame: they show the painting at the right moments and from the right places.
#include "layerpainter/film/painting_film.h"

#include "doodling/clip/open_clip.h"
#include "formats/png_file.h"
#include "painting/edit/element_edits.h"
#include "painting/edit/layer_edits.h"
#include "painting/edit/look_edits.h"
#include "painting/edit/scene_edits.h"

#include <QTemporaryDir>
#include <QtTest>
#include <numbers>

using namespace ductus;

namespace {

/// A red ball on the left, a green one on the right; the whole stack moves down by 1 in a second.
Painting balls()
{
    AddedStack stack = *addStack({}, "Balls");
    std::vector<std::shared_ptr<const ElementShape>> shapes;
    for (const float x : {-1.f, 1.f}) {
        StrokeShape ball;
        const Eigen::Vector3f colour = x < 0 ? Eigen::Vector3f(1, 0, 0) : Eigen::Vector3f(0, 1, 0);
        ball.points.push_back({{x, 0, 0}, {0, 1, 0}, 0.5f, colour, 1});
        shapes.push_back(std::make_shared<const ElementShape>(ball));
    }
    Painting painting = addElements(stack.painting, stack.substrate, shapes)->painting;
    PlacementKey from{0, {}, KeyInterpolation::Linear}, to{1, {}, KeyInterpolation::Linear};
    to.placement.translation.y() = -1;
    return *setLayerMotion(painting, stack.substrate, {from, to});
}

CameraKey front()
{
    const FrameCamera camera = FrameCamera::lookingAt({0, 0, 6}, Vec3::Zero(), 40, 1);
    return {0, camera.eye, camera.rotation, 40, {}};
}

PaintingFilm smallFilm(FilmPlan::View view, int frames)
{
    PaintingFilm film;
    film.frames.width = 96;
    film.frames.height = 64;
    film.plan.view = view;
    film.plan.from = front();
    film.plan.frames = frames;
    film.plan.rate = {4, 1};
    return film;
}

/// Mean place of pixels that are more of channel \a c than of the others; nothing if there are none.
std::optional<Eigen::Vector2d> middleOf(const Image &image, int c)
{
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    int count = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const std::uint8_t *p =
                image.pixels.data() + 4 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x));
            if (p[c] > 150 && p[(c + 1) % 3] < 100 && p[(c + 2) % 3] < 100 && p[3] > 128) {
                sum += Eigen::Vector2d(x, y);
                ++count;
            }
        }
    return count > 20 ? std::optional<Eigen::Vector2d>(sum / count) : std::nullopt;
}

} // namespace

class PaintingFilmTest : public QObject
{
    Q_OBJECT
private slots:
    void lengthsComeFromTheMotion();
    void turntablesGoAroundOnce();
    void motionPlays();
    void picturesKeepTransparency();
    void graphicsAndReferenceAgree();
    void cancelledFilmsLeaveNothing();
    void wrongKindsAreRefused();
    void namesOfLooks();

private:
    std::filesystem::path file(const char *name) const
    {
        return std::filesystem::path(mFolder.path().toStdString()) / name;
    }
    Image frame(const char *folder, int number) const
    {
        char name[32];
        std::snprintf(name, sizeof name, "frame-%05d.png", number);
        return *readPng(file(folder) / name);
    }

    QTemporaryDir mFolder;
    std::shared_ptr<const Painting> mBalls = std::make_shared<const Painting>(balls());
};

void PaintingFilmTest::lengthsComeFromTheMotion()
{
    QCOMPARE(motionSeconds({}), 0.0);
    QCOMPARE(motionSeconds(*mBalls), 1.0);
    Painting painting = *mBalls;
    CameraKey key = front();
    key.timeSeconds = 2.5;
    painting.camera.keys = {front(), key};
    QCOMPARE(motionSeconds(painting), 2.5);
    painting.stacks[0].substrate->drawings.resize(2);
    painting.stacks[0].substrate->frames = {2, 3, {0, 1}}; // two frames at 2 a second, three times
    QCOMPARE(motionSeconds(painting), 3.0);
    painting.loopSeconds = 0.75;
    QCOMPARE(motionSeconds(painting), 0.75);
    QCOMPARE(framesOf(2, {25, 1}), 50);
    QCOMPARE(framesOf(0.001, {25, 1}), 1);
}

void PaintingFilmTest::turntablesGoAroundOnce()
{
    PaintingFilm film = smallFilm(FilmPlan::View::Turntable, 4);
    film.plan.beginSeconds = 0;
    Painting still = *setLayerMotion(*mBalls, mBalls->stacks[0].substrate->id, {});
    for (int i = 0; i < 4; ++i) {
        const FrameCamera camera = cameraOf(still, film.plan, i, 1.5);
        const double angle = i * std::numbers::pi / 2;
        QVERIFY((camera.eye - Vec3(6 * std::sin(angle), 0, 6 * std::cos(angle))).norm() < 1e-9);
        QVERIFY((camera.rotation * Vec3(0, 0, -1) + camera.eye.normalized()).norm() < 1e-9);
    }
    const Result<void> written = writeFilm(std::make_shared<const Painting>(still), film, file("turn"), {});
    QVERIFY2(written, written ? "" : written.error().message().c_str());
    const Image first = frame("turn", 1), half = frame("turn", 3);
    QVERIFY(middleOf(first, 0)->x() < 40 && middleOf(first, 1)->x() > 56);
    QVERIFY(middleOf(half, 0)->x() > 56 && middleOf(half, 1)->x() < 40);
    QVERIFY(!std::filesystem::exists(file("turn") / "frame-00005.png"));
}

void PaintingFilmTest::motionPlays()
{
    PaintingFilm film = smallFilm(FilmPlan::View::Still, 4);
    QVERIFY(writeFilm(mBalls, film, file("move"), {}).ok());
    double last = -1;
    for (int i = 1; i <= 4; ++i) { // a quarter of a unit lower each time
        const double y = middleOf(frame("move", i), 0)->y();
        const double expected = 32 * (1 + 0.25 * (i - 1) / (6 * std::tan(20 * std::numbers::pi / 180)));
        QVERIFY2(std::abs(y + 0.5 - expected) < 1.0, qPrintable(QString::number(y)));
        QVERIFY(y > last);
        last = y;
    }
    // The same as MP4: one frame each, and the ball moves as far.
    QVERIFY(writeFilm(mBalls, film, file("move.mp4"), {}).ok());
    const auto clip = openClip(file("move.mp4"), {});
    QVERIFY2(clip, clip ? "" : clip.error().message().c_str());
    QCOMPARE((*clip)->info().frameCount, 4);
}

void PaintingFilmTest::picturesKeepTransparency()
{
    PaintingFilm film = smallFilm(FilmPlan::View::Still, 1);
    film.frames.transparentBackground = true;
    QVERIFY(writeFilm(mBalls, film, file("clear"), {}).ok());
    const Image image = frame("clear", 1);
    QCOMPARE(int(image.pixels[3]), 0);
    QVERIFY(middleOf(image, 0).has_value());
}

void PaintingFilmTest::graphicsAndReferenceAgree()
{
    FrameOptions options;
    options.width = 96;
    options.height = 64;
    const FrameCamera camera = FrameCamera::of(front(), 1.5);
    const auto drawn = makeFrames(mBalls, options);
    options.exact = true;
    const auto exact = makeFrames(mBalls, options);
    QVERIFY(!exact->usesGraphics());
    if (!drawn->usesGraphics())
        QSKIP("no OpenGL 4.3 here");
    const Image a = *drawn->frame({}, camera, {}), b = *exact->frame({}, camera, {});
    int different = 0;
    for (std::size_t i = 0; i < a.pixels.size(); i += 4)
        for (std::size_t k = 0; k < 4; ++k)
            if (std::abs(int(a.pixels[i + k]) - int(b.pixels[i + k])) > 2) {
                ++different;
                break;
            }
    // Where samples lie inside a pixel differs along borders.
    QVERIFY2(different < 96 * 64 / 20, qPrintable(QString::number(different)));
}

void PaintingFilmTest::cancelledFilmsLeaveNothing()
{
    std::atomic<bool> cancelled = false;
    const JobControl control(&cancelled, [&](double fraction, std::string_view) {
        if (fraction > 0.4)
            cancelled = true;
    });
    const Result<void> written =
        writeFilm(mBalls, smallFilm(FilmPlan::View::Turntable, 10), file("stop.mp4"), control);
    QVERIFY(!written.ok() && written.error().isCancelled());
    for (const auto &entry : std::filesystem::directory_iterator(file("")))
        QVERIFY2(entry.path().filename().string().find("stop") == std::string::npos, entry.path().c_str());
}

void PaintingFilmTest::wrongKindsAreRefused()
{
    PaintingFilm film = smallFilm(FilmPlan::View::Still, 1);
    QCOMPARE(writeFilm(mBalls, film, file("x.avi"), {}).error().code, ErrorCode::InvalidArgument);
    film.frames.transparentBackground = true;
    QCOMPARE(writeFilm(mBalls, film, file("x.mp4"), {}).error().code, ErrorCode::InvalidArgument);
    film.plan.frames = 0;
    QCOMPARE(writeFilm(mBalls, film, file("x.gif"), {}).error().code, ErrorCode::InvalidArgument);
    film = smallFilm(FilmPlan::View::Still, 1);
    film.look = LookId{77};
    QVERIFY(!writeFilm(mBalls, film, file("x.gif"), {}).ok());
    QVERIFY(!std::filesystem::exists(file("x.gif")));
}

void PaintingFilmTest::namesOfLooks()
{
    QCOMPARE(pathForLook("a/desk.mp4", "Night", 1), std::filesystem::path("a/desk-Night.mp4"));
    QCOMPARE(pathForLook("desk.mp4", "../été: 木", 1), std::filesystem::path("desk-..été 木.mp4"));
    QCOMPARE(pathForLook("desk.mp4", "//", 3), std::filesystem::path("desk-3.mp4"));
    QCOMPARE(pathForLook("frames", "Day", 1), std::filesystem::path("frames-Day"));
}

QTEST_APPLESS_MAIN(PaintingFilmTest)
#include "painting_film_test.moc"
