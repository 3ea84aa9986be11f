#include "doodling/clip/clip.h"

#include "formats/png_file.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <fstream>

using namespace ductus;

namespace {

constexpr int width = 64, height = 48;

// Grey says which frame it is; the left quarter is red, so that up and left can be told.
Image numbered(int index)
{
    const std::uint8_t grey = std::uint8_t(20 + 7 * index);
    Image image(width, height, {grey, grey, grey, 255});
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width / 4; ++x)
            image.set(x, y, {200, 20, 20, 255});
    return image;
}

int numberOf(const Image &image)
{
    const Rgba middle = image.at(image.width * 5 / 8, image.height * 5 / 8);
    return int(std::lround((middle[1] - 20) / 7.0));
}

bool isRed(const Rgba &colour)
{
    return colour[0] > 120 && colour[1] < 90;
}

} // namespace

class ClipTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void everyFrameIsTheOneAskedFor_data();
    void everyFrameIsTheOneAskedFor();
    void coloursAreThoseTheFilmSays_data();
    void coloursAreThoseTheFilmSays();
    void rotationIsApplied_data();
    void rotationIsApplied();
    void timesOfUnevenFrames();
    void aCutFileGivesWhatIsThere();
    void oneFrame();
    void foldersInNameOrder();
    void scaling();
    void whatIsNoClipIsRefused();

private:
    void make(const QString &name, const QStringList &arguments, int frames = 30);
    std::filesystem::path at(const QString &name) const { return mFolder.filePath(name).toStdString(); }

    QTemporaryDir mFolder;
};

void ClipTest::initTestCase()
{
    if (QProcess::execute(QStringLiteral("ffmpeg"), {QStringLiteral("-version")}) != 0)
        QSKIP("the ffmpeg program, which makes the clips of this test, is not installed");
    QDir().mkpath(mFolder.filePath("frames"));
    for (int i = 0; i < 30; ++i)
        QVERIFY(writePng(numbered(i), at(QString("frames/frame%1.png").arg(i))).ok());
}

void ClipTest::make(const QString &name, const QStringList &arguments, int frames)
{
    QStringList all{"-y",
                    "-v",
                    "error",
                    "-framerate",
                    "25",
                    "-i",
                    mFolder.filePath("frames/frame%d.png"),
                    "-frames:v",
                    QString::number(frames)};
    QProcess ffmpeg;
    ffmpeg.start("ffmpeg", all + arguments + QStringList{mFolder.filePath(name)});
    QVERIFY(ffmpeg.waitForFinished(60000));
    QVERIFY2(ffmpeg.exitCode() == 0, ffmpeg.readAllStandardError().constData());
}

void ClipTest::everyFrameIsTheOneAskedFor_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("h264 with b-frames")
        << "b.mp4"
        << QStringList{"-c:v", "libx264", "-bf", "3", "-g", "12", "-crf", "4", "-pix_fmt", "yuv420p"};
    QTest::newRow("one key frame") << "long.mkv" << QStringList{"-c:v", "libx264", "-g",       "300",
                                                                "-crf", "4",       "-pix_fmt", "yuv420p"};
    QTest::newRow("vp9") << "v.webm" << QStringList{"-c:v", "libvpx-vp9", "-crf", "4", "-b:v", "0"};
    QTest::newRow("10 bit") << "ten.mkv"
                            << QStringList{"-c:v", "libx264", "-crf", "4", "-pix_fmt", "yuv420p10le"};
    QTest::newRow("mjpeg") << "m.avi" << QStringList{"-c:v", "mjpeg", "-q:v", "2"};
}

void ClipTest::everyFrameIsTheOneAskedFor()
{
    QFETCH(QString, name);
    QFETCH(QStringList, arguments);
    make(name, arguments);
    auto clip = openClip(at(name), {});
    QVERIFY2(clip.ok(), clip.ok() ? "" : clip.error().message().c_str());
    const ClipInfo &info = (*clip)->info();
    QCOMPARE(info.frameCount, 30);
    QCOMPARE(info.width, width);
    QCOMPARE(info.height, height);
    QVERIFY(std::abs(info.framesPerSecond - 25.0) < 0.05);
    QVERIFY(!info.hasAudio);
    QVERIFY(info.warnings.empty());
    for (int index : {0, 1, 2, 17, 3, 29, 28, 12, 11, 0, 29}) {
        const Result<Image> frame = (*clip)->frame(index);
        QVERIFY2(frame.ok(), frame.ok() ? "" : frame.error().message().c_str());
        QCOMPARE(numberOf(*frame), index);
        QVERIFY(isRed(frame->at(4, 24)));
    }
    QVERIFY(!(*clip)->frame(30).ok());
    QVERIFY(!(*clip)->frame(-1).ok());
}

void ClipTest::coloursAreThoseTheFilmSays_data()
{
    QTest::addColumn<QString>("matrix");
    QTest::addColumn<QString>("range");
    for (const char *matrix : {"bt709", "smpte170m", "bt470bg", "bt2020nc"})
        for (const char *range : {"tv", "pc"})
            QTest::addRow("%s %s", matrix, range) << matrix << range;
}

void ClipTest::coloursAreThoseTheFilmSays()
{
    QFETCH(QString, matrix);
    QFETCH(QString, range);
    const QString scaled = matrix == QLatin1String("bt2020nc") ? QStringLiteral("bt2020") : matrix;
    const QString name = matrix + range + ".mkv";
    make(name,
         {"-vf", QString("scale=out_color_matrix=%1:out_range=%2:sws_flags=accurate_rnd").arg(scaled, range),
          "-c:v", "libx264", "-crf", "2", "-pix_fmt", "yuv444p", "-colorspace", matrix, "-color_range",
          range},
         2);
    auto clip = openClip(at(name), {});
    QVERIFY(clip.ok());
    const Result<Image> frame = (*clip)->frame(1);
    QVERIFY(frame.ok());
    const Rgba red = frame->at(4, 24), grey = frame->at(40, 24);
    const Rgba wantedRed{200, 20, 20, 255}, wantedGrey{27, 27, 27, 255};
    for (std::size_t c = 0; c < 3; ++c) {
        QVERIFY2(std::abs(int(red[c]) - int(wantedRed[c])) <= 4,
                 qPrintable(QString("red %1 %2 %3").arg(red[0]).arg(red[1]).arg(red[2])));
        QVERIFY(std::abs(int(grey[c]) - int(wantedGrey[c])) <= 3);
    }
}

void ClipTest::rotationIsApplied_data()
{
    QTest::addColumn<int>("noted");
    QTest::newRow("90") << 90;
    QTest::newRow("180") << 180;
    QTest::newRow("270") << 270;
}

void ClipTest::rotationIsApplied()
{
    QFETCH(int, noted);
    make("plain.mp4", {"-c:v", "libx264", "-crf", "4", "-pix_fmt", "yuv420p"});
    const auto run = [&](const QStringList &arguments) {
        return QProcess::execute("ffmpeg", QStringList{"-y", "-v", "error"} + arguments);
    };
    QCOMPARE(run({"-i", mFolder.filePath("plain.mp4"), "-c", "copy", "-metadata:s:v",
                  QString("rotate=%1").arg(noted), mFolder.filePath("turned.mp4")}),
             0);
    // What ffmpeg's own player would show.
    QCOMPARE(run({"-i", mFolder.filePath("turned.mp4"), "-frames:v", "1", mFolder.filePath("shown.png")}), 0);
    const Result<Image> shown = readPng(at("shown.png"));
    QVERIFY(shown.ok());
    auto clip = openClip(at("turned.mp4"), {});
    QVERIFY(clip.ok());
    QCOMPARE((*clip)->info().width, shown->width);
    QCOMPARE((*clip)->info().height, shown->height);
    const Result<Image> frame = (*clip)->frame(0);
    QVERIFY(frame.ok());
    QCOMPARE(frame->width, shown->width);
    for (int y = 4; y < shown->height; y += 8)
        for (int x = 4; x < shown->width; x += 8)
            QCOMPARE(isRed(frame->at(x, y)), isRed(shown->at(x, y)));
}

void ClipTest::timesOfUnevenFrames()
{
    make("uneven.mkv", {"-vf", "setpts='(N+N*N/10)*0.04/TB'", "-vsync", "vfr", "-c:v", "libx264", "-crf", "4",
                        "-pix_fmt", "yuv420p"});
    auto clip = openClip(at("uneven.mkv"), {});
    QVERIFY(clip.ok());
    const ClipInfo &info = (*clip)->info();
    QCOMPARE(info.frameCount, 30);
    for (int i = 0; i < 30; ++i)
        QVERIFY(std::abs(info.frameTimes[std::size_t(i)] - (i + i * i / 10.0) * 0.04) < 0.045);
    for (int index : {22, 7, 29})
        QCOMPARE(numberOf(*(*clip)->frame(index)), index);
}

void ClipTest::aCutFileGivesWhatIsThere()
{
    make("whole.mkv", {"-c:v", "libx264", "-bf", "2", "-g", "6", "-crf", "1", "-pix_fmt", "yuv420p", "-vf",
                       "noise=alls=40:allf=t"});
    std::ifstream in(at("whole.mkv"), std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(in)), {});
    std::ofstream(at("cut.mkv"), std::ios::binary) << bytes.substr(0, bytes.size() * 6 / 10);
    auto clip = openClip(at("cut.mkv"), {});
    QVERIFY2(clip.ok(), clip.ok() ? "" : clip.error().message().c_str());
    const int count = (*clip)->info().frameCount;
    QVERIFY2(count > 10 && count < 25, qPrintable(QString::number(count)));
    QVERIFY((*clip)->frame(count - 1).ok());
    QVERIFY((*clip)->frame(0).ok());
    std::ofstream(at("stub.mkv"), std::ios::binary) << bytes.substr(0, 300);
    QVERIFY(!openClip(at("stub.mkv"), {}).ok());
}

void ClipTest::oneFrame()
{
    make("one.mp4", {"-c:v", "libx264", "-crf", "4", "-pix_fmt", "yuv420p"}, 1);
    auto clip = openClip(at("one.mp4"), {});
    QVERIFY(clip.ok());
    QCOMPARE((*clip)->info().frameCount, 1);
    QCOMPARE(numberOf(*(*clip)->frame(0)), 0);
}

void ClipTest::foldersInNameOrder()
{
    auto clip = openClip(at("frames"), {}); // frame0 .. frame29, without leading zeros
    QVERIFY(clip.ok());
    QCOMPARE((*clip)->info().frameCount, 30);
    QCOMPARE((*clip)->info().width, width);
    for (int index : {0, 9, 10, 2, 29})
        QCOMPARE(numberOf(*(*clip)->frame(index)), index);
    QDir().mkpath(mFolder.filePath("none"));
    QCOMPARE(openClip(at("none"), {}).error().code, ErrorCode::Unsupported);
}

void ClipTest::scaling()
{
    QCOMPARE(scaledSize(1920, 1080, 480), std::pair(854, 480));
    QCOMPARE(scaledSize(640, 360, 480), std::pair(640, 360));
    QCOMPARE(scaledSize(641, 361, 0), std::pair(641, 361));
    auto clip = openClip(at("frames"), {});
    const Result<Image> small = (*clip)->frame(3, 24);
    QVERIFY(small.ok());
    QCOMPARE(small->width, 32);
    QCOMPARE(small->height, 24);
    QCOMPARE(numberOf(*small), 3);
}

void ClipTest::whatIsNoClipIsRefused()
{
    QCOMPARE(openClip(at("absent.mp4"), {}).error().code, ErrorCode::FileNotFound);
    std::ofstream(at("text.mp4")) << "not a video";
    const auto text = openClip(at("text.mp4"), {});
    QVERIFY(!text.ok());
    QVERIFY(text.error().message().find("text.mp4") != std::string::npos);
    QVERIFY(!text.error().remedy.empty());
    std::ofstream(at("empty.mp4")).close();
    QVERIFY(!openClip(at("empty.mp4"), {}).ok());
    QProcess ffmpeg;
    ffmpeg.start("ffmpeg", {"-y", "-v", "error", "-f", "lavfi", "-i", "sine=duration=1",
                            mFolder.filePath("sound.wav")});
    QVERIFY(ffmpeg.waitForFinished(60000));
    QCOMPARE(openClip(at("sound.wav"), {}).error().code, ErrorCode::Unsupported);
}

QTEST_GUILESS_MAIN(ClipTest)
#include "clip_test.moc"
