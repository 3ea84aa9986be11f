#include "doodling/export/export_film.h"

#include "doodling/canvas/edit_doodle.h"
#include "doodling/canvas/edit_scene.h"
#include "doodling/export/depth_picture.h"
#include "formats/film/output_place.h"
#include "formats/film/testing/film_facts.h"
#include "formats/png_file.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <atomic>
#include <fstream>

using namespace ductus;
namespace fs = std::filesystem;

namespace {

constexpr int width = 64, height = 48, frames = 12;

// Grey says which frame it is; the left quarter is red.
Image numbered(int index)
{
    const std::uint8_t grey = std::uint8_t(40 + 12 * index);
    Image image(width, height, {grey, grey, grey, 255});
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width / 4; ++x)
            image.set(x, y, {200, 20, 20, 255});
    return image;
}

int numberOf(const Image &image)
{
    return int(std::lround((image.at(image.width * 5 / 8, image.height * 7 / 8)[1] - 40) / 12.0));
}

// Nothing moves and all is at depth 10; a near thing covers the right half.
Shot shotOf(const ClipInfo &info)
{
    Shot shot;
    shot.width = shot.clipWidth = info.width;
    shot.height = shot.clipHeight = info.height;
    ShotCamera camera;
    camera.focal = info.width;
    camera.centre = Vec2(0.5 * info.width, 0.5 * info.height);
    const std::size_t count = std::size_t(info.frameCount);
    shot.cameras.assign(count, camera);
    std::vector<float> disparities;
    const int cellsWide = (info.width + 3) / 4, cellsHigh = (info.height + 3) / 4;
    for (int y = 0; y < cellsHigh; ++y)
        for (int x = 0; x < cellsWide; ++x)
            disparities.push_back(x >= cellsWide * 3 / 4 ? 0.5f : 0.1f);
    shot.depths.assign(count, depthMapOf(cellsWide, cellsHigh, 4.0, disparities));
    return shot;
}

// A green area over the middle half of the picture, at depth 5.
DoodleScene greenScene(const ClipInfo &info)
{
    Canvas canvas;
    canvas.name = "green";
    canvas.keyframes.positions = {{0, Vec2(0.5 * info.width, 0.5 * info.height), 5.0, false}};
    const double w = 1.25, h = 1.25 * info.height / info.width; // half as wide and high as is seen at depth 5
    canvas.doodle =
        *withMark(canvas.doodle, 0, FilledShape{{{-w, -h}, {w, -h}, {w, h}, {-w, h}}, {0, 220, 0, 255}});
    return *withCanvas({}, canvas);
}

bool isGreen(const Rgba &c)
{
    return c[1] > 180 && c[0] < 60 && c[2] < 60;
}

template <typename T>
QString problemOf(const Result<T> &result)
{
    return result.ok() ? QString() : QString::fromStdString(result.error().message());
}

#define VERIFY_OK(expression)                                                                                \
    do {                                                                                                     \
        const QString problem = problemOf(expression);                                                       \
        QVERIFY2(problem.isEmpty(), qPrintable(problem));                                                    \
    } while (false)

} // namespace

class ExportFilmTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void cleanup();
    void everyFrameWithItsDoodle_data();
    void everyFrameWithItsDoodle();
    void unevenTimesAreKept();
    void turnedClipsComeOutUpright();
    void oneFrame();
    void theCutEndIsLeftOut();
    void soundIsKept();
    void doodlesAlone();
    void depthIsLightWhereNear();
    void everySecondFrameAsASmallGif();
    void cancelledExportsLeaveNothing();
    void otherClipsAreRefused();

private:
    fs::path at(const QString &name) const { return mFolder.filePath(name).toStdString(); }
    void make(const QString &name, const QStringList &arguments, int count = frames);
    Result<ExportReport> exported(const QString &from, const QString &to, FilmExport what = {},
                                  const JobControl &control = {});

    QTemporaryDir mFolder;
};

void ExportFilmTest::initTestCase()
{
    if (QProcess::execute(QStringLiteral("ffmpeg"), {QStringLiteral("-version")}) != 0)
        QSKIP("the ffmpeg program, which makes the clips of this test, is not installed");
    QDir().mkpath(mFolder.filePath("frames"));
    for (int i = 0; i < frames; ++i)
        QVERIFY(writePng(numbered(i), at(QString("frames/frame%1.png").arg(i))).ok());
}

void ExportFilmTest::cleanup()
{
    // Whatever happened, no temporary is left.
    QCOMPARE(QDir(mFolder.path()).entryList({".ductus*"}, QDir::AllEntries | QDir::Hidden), QStringList());
}

void ExportFilmTest::make(const QString &name, const QStringList &arguments, int count)
{
    const QStringList all{"-y",
                          "-v",
                          "error",
                          "-framerate",
                          "25",
                          "-i",
                          mFolder.filePath("frames/frame%d.png"),
                          "-frames:v",
                          QString::number(count)};
    QCOMPARE(QProcess::execute("ffmpeg", all + arguments +
                                             QStringList{"-c:v", "libx264", "-crf", "4", "-pix_fmt",
                                                         "yuv420p", mFolder.filePath(name)}),
             0);
}

Result<ExportReport> ExportFilmTest::exported(const QString &from, const QString &to, FilmExport what,
                                              const JobControl &control)
{
    Result<std::unique_ptr<Clip>> clip = openClip(at(from), {});
    if (!clip)
        return clip.error();
    what.kind = *filmKindOf(to.toStdString());
    const ClipInfo &info = (*clip)->info();
    return exportFilm(**clip, at(from), shotOf(info), greenScene(info), what, at(to), control);
}

void ExportFilmTest::everyFrameWithItsDoodle_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name : {"out.mp4", "out.webm", "out.gif"})
        QTest::newRow(name) << name;
}

void ExportFilmTest::everyFrameWithItsDoodle()
{
    QFETCH(QString, name);
    make("plain.mp4", {});
    const Result<ExportReport> report = exported("plain.mp4", name);
    VERIFY_OK(report);
    QCOMPARE(report->frames, frames);
    QVERIFY(report->hasEvenRate && !report->hasSound);
    QCOMPARE(report->rate, (FrameRate{25, 1}));
    const Result<FilmFacts> facts = filmFacts(at(name));
    VERIFY_OK(facts);
    QCOMPARE(int(facts->frames.size()), frames);
    QCOMPARE(facts->width, width);
    QVERIFY(facts->soundCodec.empty());
    for (int t = 0; t < frames; ++t) {
        const Image &image = facts->frames[std::size_t(t)];
        QCOMPARE(numberOf(image), t);
        QVERIFY(isGreen(image.at(width / 2, height / 2)));
        QVERIFY(isGreen(image.at(width / 4 + 3, height / 4 + 3)));
        QVERIFY(!isGreen(image.at(width / 2, height / 8)));
        QVERIFY(!isGreen(image.at(width * 7 / 8, height / 2))); // hidden by what is near, and beyond it
        QVERIFY(image.at(4, height / 2)[0] > 150);
    }
}

void ExportFilmTest::unevenTimesAreKept()
{
    make("uneven.mkv", {"-vf", "setpts='(N+N*N/6)*0.04/TB'", "-vsync", "vfr"});
    const Result<ExportReport> report = exported("uneven.mkv", "out.mp4");
    VERIFY_OK(report);
    QVERIFY(!report->hasEvenRate);
    const Result<FilmFacts> facts = filmFacts(at("out.mp4"));
    VERIFY_OK(facts);
    QCOMPARE(int(facts->frames.size()), frames);
    const std::vector<double> times = (*openClip(at("uneven.mkv"), {}))->info().frameTimes;
    QVERIFY(times.back() > 0.04 * (frames + 3)); // it is uneven
    for (int t = 0; t < frames; ++t) {
        const double expected = times[std::size_t(t)];
        QVERIFY2(std::abs(facts->frameTimes[std::size_t(t)] - facts->frameTimes[0] - expected) < 0.0021,
                 qPrintable(QString("frame %1 at %2").arg(t).arg(facts->frameTimes[std::size_t(t)])));
    }
}

void ExportFilmTest::turnedClipsComeOutUpright()
{
    make("plain.mp4", {});
    QCOMPARE(
        QProcess::execute("ffmpeg", {"-y", "-v", "error", "-i", mFolder.filePath("plain.mp4"), "-c", "copy",
                                     "-metadata:s:v", "rotate=90", mFolder.filePath("turned.mp4")}),
        0);
    VERIFY_OK(exported("turned.mp4", "out.mp4"));
    const Result<FilmFacts> facts = filmFacts(at("out.mp4")); // as stored: no rotation is looked at
    VERIFY_OK(facts);
    QCOMPARE(facts->width, height);
    QCOMPARE(facts->height, width);
    auto clip = openClip(at("out.mp4"), {});
    VERIFY_OK(clip);
    QCOMPARE((*clip)->info().rotationDegrees, 0);
    auto source = openClip(at("turned.mp4"), {});
    const Image before = *(*source)->frame(3);
    const Image &after = facts->frames[3];
    for (const auto &[x, y] :
         {std::pair(4, 4), {44, 4}, {4, 60}, {44, 60}}) // the corners, clear of the doodle
        QVERIFY(std::abs(int(before.at(x, y)[0]) - int(after.at(x, y)[0])) < 25);
    QVERIFY(isGreen(after.at(height / 2, width / 2)));
}

void ExportFilmTest::oneFrame()
{
    make("one.mp4", {}, 1);
    const Result<ExportReport> report = exported("one.mp4", "out.mp4");
    VERIFY_OK(report);
    QCOMPARE(report->frames, 1);
    QCOMPARE(int(filmFacts(at("out.mp4"))->frames.size()), 1);
}

void ExportFilmTest::theCutEndIsLeftOut()
{
    make("whole.mkv", {"-g", "4", "-vf", "noise=alls=40:allf=t"}); // large enough to be cut in its middle
    std::ifstream whole(at("whole.mkv"), std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(whole)), {});
    std::ofstream(at("cut.mkv"), std::ios::binary) << bytes.substr(0, bytes.size() * 2 / 3);
    const Result<ExportReport> report = exported("cut.mkv", "out.mp4");
    VERIFY_OK(report);
    QVERIFY(report->frames > 0 && report->frames < frames);
    QCOMPARE(int(filmFacts(at("out.mp4"))->frames.size()), report->frames);
}

void ExportFilmTest::soundIsKept()
{
    QCOMPARE(QProcess::execute("ffmpeg", {"-y",
                                          "-v",
                                          "error",
                                          "-framerate",
                                          "25",
                                          "-i",
                                          mFolder.filePath("frames/frame%d.png"),
                                          "-f",
                                          "lavfi",
                                          "-i",
                                          "sine=frequency=440",
                                          "-t",
                                          "0.48",
                                          "-c:v",
                                          "libx264",
                                          "-crf",
                                          "4",
                                          "-pix_fmt",
                                          "yuv420p",
                                          "-c:a",
                                          "aac",
                                          mFolder.filePath("loud.mp4")}),
             0);
    const Result<ExportReport> report = exported("loud.mp4", "out.mp4");
    VERIFY_OK(report);
    QVERIFY(report->hasSound);
    const Result<FilmFacts> facts = filmFacts(at("out.mp4"));
    QCOMPARE(QString::fromStdString(facts->soundCodec), QString("aac"));
    QVERIFY(std::abs(facts->soundSeconds - 0.48) < 0.06);
    FilmExport silent;
    silent.withSound = false;
    VERIFY_OK(exported("loud.mp4", "silent.mp4", silent));
    QVERIFY(filmFacts(at("silent.mp4"))->soundCodec.empty());
}

void ExportFilmTest::doodlesAlone()
{
    make("plain.mp4", {});
    FilmExport what;
    what.content = ExportContent::Doodle;
    VERIFY_OK(exported("plain.mp4", "alone.webm", what));
    const Result<FilmFacts> webm = filmFacts(at("alone.webm"));
    VERIFY_OK(webm);
    QVERIFY(webm->frames[5].at(width / 2, height / 2)[3] > 240);
    QVERIFY(webm->frames[5].at(3, 3)[3] < 12);
    VERIFY_OK(exported("plain.mp4", "alone.mp4", what)); // over white
    const Result<FilmFacts> mp4 = filmFacts(at("alone.mp4"));
    VERIFY_OK(mp4);
    QVERIFY(mp4->frames[5].at(3, 3)[0] > 240);
    QVERIFY(isGreen(mp4->frames[5].at(width / 2, height / 2)));
    VERIFY_OK(exported("plain.mp4", "alone", what));
    const Result<Image> png = readPng(at("alone") / numberedPicture(frames));
    VERIFY_OK(png);
    QVERIFY(png->at(width / 2, height / 2) == (Rgba{0, 220, 0, 255}));
    QCOMPARE(int(png->at(3, 3)[3]), 0);
}

void ExportFilmTest::depthIsLightWhereNear()
{
    make("plain.mp4", {});
    FilmExport what;
    what.content = ExportContent::Depth;
    VERIFY_OK(exported("plain.mp4", "depth", what));
    const Result<Image> png = readPng(at("depth") / numberedPicture(4));
    VERIFY_OK(png);
    QVERIFY(png->at(width - 4, height / 2)[0] > 250);
    QVERIFY(png->at(4, height / 2)[0] < 5);
    Shot flat;
    flat.width = flat.height = 8;
    flat.cameras.resize(2);
    QCOMPARE(int(depthPicture(flat, 0, disparityRange(flat), 4, 4).at(1, 1)[0]), 128); // one depth: grey
}

void ExportFilmTest::everySecondFrameAsASmallGif()
{
    make("plain.mp4", {});
    FilmExport what;
    what.everyNth = 2;
    what.mostLines = 24;
    const Result<ExportReport> report = exported("plain.mp4", "small.gif", what);
    VERIFY_OK(report);
    QCOMPARE(report->frames, frames / 2);
    const Result<FilmFacts> facts = filmFacts(at("small.gif"));
    VERIFY_OK(facts);
    QCOMPARE(facts->height, 24);
    QVERIFY(std::abs(facts->seconds - 0.48) < 0.011);
    QCOMPARE(numberOf(facts->frames[3]), 6);
}

void ExportFilmTest::cancelledExportsLeaveNothing()
{
    make("plain.mp4", {});
    for (const char *name : {"never.mp4", "never.webm", "never.gif", "never"}) {
        std::atomic<bool> cancel = false;
        const JobControl control(&cancel, [&](double fraction, std::string_view) {
            if (fraction > 0.3)
                cancel = true;
        });
        const Result<ExportReport> report = exported("plain.mp4", name, {}, control);
        QVERIFY(!report.ok() && report.error().isCancelled());
        QVERIFY(!fs::exists(at(name)));
        cleanup();
    }
}

void ExportFilmTest::otherClipsAreRefused()
{
    make("plain.mp4", {});
    auto clip = openClip(at("plain.mp4"), {});
    VERIFY_OK(clip);
    ClipInfo other = (*clip)->info();
    other.frameCount = 5;
    const Result<ExportReport> report =
        exportFilm(**clip, at("plain.mp4"), shotOf(other), greenScene(other), {}, at("never.mp4"), {});
    QVERIFY(!report.ok());
    QVERIFY(!fs::exists(at("never.mp4")));
}

QTEST_APPLESS_MAIN(ExportFilmTest)
#include "export_film_test.moc"
