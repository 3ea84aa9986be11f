#include "formats/film/film_writer.h"

#include "formats/film/output_place.h"
#include "formats/film/testing/film_facts.h"
#include "formats/png_file.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <numbers>

using namespace ductus;
namespace fs = std::filesystem;

namespace {

// Soft colours that move, a dark bar that says which frame it is.
Image picture(int width, int height, int index)
{
    Image image(width, height, {0, 0, 0, 255});
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.set(x, y,
                      {std::uint8_t(60 + 120 * x / width), std::uint8_t(200 - 120 * y / height),
                       std::uint8_t(90 + 4 * index), 255});
    for (int y = 0; y < height / 4; ++y)
        for (int x = 4 * index; x < 4 * index + 8 && x < width; ++x)
            image.set(x, y, {20, 20, 20, 255});
    return image;
}

// A red disc on nothing.
Image disc(int size, int index)
{
    Image image(size, size, {0, 0, 0, 0});
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            if (std::hypot(x - size / 3.0 - 3 * index, y - size / 2.0) < size / 4.0)
                image.set(x, y, {220, 30, 30, 255});
    return image;
}

QString textOf(const Error &error)
{
    return QString::fromStdString(error.message());
}

template <typename T>
QString problemOf(const Result<T> &result)
{
    return result.ok() ? QString() : textOf(result.error());
}

// The expression is evaluated once.
#define VERIFY_OK(expression)                                                                                \
    do {                                                                                                     \
        const QString problem = problemOf(expression);                                                       \
        QVERIFY2(problem.isEmpty(), qPrintable(problem));                                                    \
    } while (false)

} // namespace

class FilmWriterTest : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void kindsByName();
    void filmsReadBackAsTheyWereGiven_data();
    void filmsReadBackAsTheyWereGiven();
    void oddSides();
    void unevenTimes();
    void transparencyIsKept();
    void noDarkSeamAroundWhatIsVisible();
    void withoutTransparencyOverTheBackground();
    void soundIsKept_data();
    void soundIsKept();
    void soundStaysInStep();
    void aSilentSourceMakesASilentFilm();
    void oneFrame();
    void nothingIsLeftOfAFilmThatWasNotFinished_data();
    void nothingIsLeftOfAFilmThatWasNotFinished();
    void anOlderFilmStaysUntilTheNewOneIsThere();
    void foldersWithOtherFilesAreLeftAlone();
    void whatCannotBeWrittenIsSaid();

private:
    fs::path at(const char *name) const { return mFolder->filePath(name).toStdString(); }
    Result<FilmFacts> written(const fs::path &path, const FilmOptions &options, int frames);
    int entryCount() const
    {
        return int(
            QDir(mFolder->path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot).size());
    }
    void makeSource(const char *name, const QStringList &sound, const QStringList &codec);

    std::unique_ptr<QTemporaryDir> mFolder;
};

void FilmWriterTest::init()
{
    mFolder = std::make_unique<QTemporaryDir>();
}

Result<FilmFacts> FilmWriterTest::written(const fs::path &path, const FilmOptions &options, int frames)
{
    Result<FilmWriter> film = FilmWriter::open(path, options);
    if (!film)
        return film.error();
    for (int i = 0; i < frames; ++i)
        if (Result<void> added = film->add(picture(options.width, options.height, i)); !added)
            return added.error();
    if (Result<void> ended = film->finish(); !ended)
        return ended.error();
    return filmFacts(path);
}

void FilmWriterTest::kindsByName()
{
    QCOMPARE(filmKindOf("a/Film.MP4"), FilmKind::Mp4);
    QCOMPARE(filmKindOf("a.webm"), FilmKind::WebM);
    QCOMPARE(filmKindOf("a.gif"), FilmKind::Gif);
    QCOMPARE(filmKindOf("folder"), FilmKind::PngFolder);
    QVERIFY(!filmKindOf("a.avi"));
}

void FilmWriterTest::filmsReadBackAsTheyWereGiven_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("codec");
    QTest::addColumn<int>("numerator");
    QTest::addColumn<int>("denominator");
    QTest::newRow("mp4 25") << "a.mp4"
                            << "h264" << 25 << 1;
    QTest::newRow("mp4 29.97") << "a.mp4"
                               << "h264" << 30000 << 1001;
    QTest::newRow("webm 24") << "a.webm"
                             << "vp9" << 24 << 1;
    QTest::newRow("webm 23.976") << "a.webm"
                                 << "vp9" << 24000 << 1001;
    QTest::newRow("gif 25") << "a.gif"
                            << "gif" << 25 << 1;
}

void FilmWriterTest::filmsReadBackAsTheyWereGiven()
{
    QFETCH(QString, name);
    QFETCH(QString, codec);
    QFETCH(int, numerator);
    QFETCH(int, denominator);
    FilmOptions options;
    options.kind = *filmKindOf(name.toStdString());
    options.width = 160;
    options.height = 90;
    options.rate = {numerator, denominator};
    const Result<FilmFacts> facts = written(at(qPrintable(name)), options, 20);
    VERIFY_OK(facts);
    QCOMPARE(QString::fromStdString(facts->videoCodec), codec);
    QCOMPARE(facts->width, 160);
    QCOMPARE(facts->height, 90);
    QCOMPARE(int(facts->frames.size()), 20);
    const double step = double(denominator) / numerator;
    QVERIFY2(std::abs(facts->seconds - 20 * step) < 0.0015, qPrintable(QString::number(facts->seconds)));
    for (std::size_t i = 0; i < 20; ++i) {
        QVERIFY(std::abs(facts->frameTimes[i] - facts->frameTimes[0] - double(i) * step) < 0.0011);
        const double off = meanDifference(facts->frames[i], picture(160, 90, int(i)));
        QVERIFY2(off < (codec == "gif" ? 6.0 : 3.0),
                 qPrintable(QString("frame %1 is off by %2").arg(i).arg(off)));
    }
    if (codec != "gif") {
        QVERIFY(facts->isBt709);
        QCOMPARE(QString::fromStdString(facts->pixelFormat), QString("yuv420p"));
        QVERIFY(std::abs(double(facts->rateNumerator) / facts->rateDenominator - 1.0 / step) < 0.01);
    }
    if (codec == "h264") { // to the last digit
        QCOMPARE(facts->rateNumerator, numerator);
        QCOMPARE(facts->rateDenominator, denominator);
    }
}

void FilmWriterTest::oddSides()
{
    FilmOptions options;
    options.width = 161;
    options.height = 91;
    const Result<FilmFacts> mp4 = written(at("a.mp4"), options, 3);
    VERIFY_OK(mp4);
    QCOMPARE(mp4->width, 162); // the last column twice
    QCOMPARE(mp4->height, 92);
    const Rgba last = mp4->frames[1].at(161, 50), before = mp4->frames[1].at(160, 50);
    QVERIFY(std::abs(last[0] - before[0]) < 8);
    options.kind = FilmKind::WebM;
    const Result<FilmFacts> webm = written(at("a.webm"), options, 3);
    VERIFY_OK(webm);
    QCOMPARE(webm->width, 161);
    QCOMPARE(webm->height, 91);
    options.kind = FilmKind::Gif;
    const Result<FilmFacts> gif = written(at("a.gif"), options, 3);
    VERIFY_OK(gif);
    QCOMPARE(gif->width, 161);
}

void FilmWriterTest::unevenTimes()
{
    const std::vector<double> times = {0.0, 0.04, 0.2, 0.25, 0.6};
    for (const char *name : {"a.mp4", "a.webm", "a.gif"}) {
        FilmOptions options;
        options.kind = *filmKindOf(name);
        options.width = 64;
        options.height = 48;
        options.rate = {10, 1};
        options.frameTimes = times;
        const Result<FilmFacts> facts = written(at(name), options, 5);
        VERIFY_OK(facts);
        QCOMPARE(int(facts->frames.size()), 5);
        for (std::size_t i = 0; i < 5; ++i)
            QVERIFY2(std::abs(facts->frameTimes[i] - facts->frameTimes[0] - times[i]) < 0.0011,
                     qPrintable(QString("%1 frame %2 at %3").arg(name).arg(i).arg(facts->frameTimes[i])));
        QVERIFY2(std::abs(facts->seconds - 0.7) < 0.011, qPrintable(QString::number(facts->seconds)));
    }
}

void FilmWriterTest::transparencyIsKept()
{
    for (const char *name : {"a.webm", "a.gif"}) {
        FilmOptions options;
        options.kind = *filmKindOf(name);
        options.width = options.height = 96;
        options.keepsAlpha = true;
        Result<FilmWriter> film = FilmWriter::open(at(name), options);
        VERIFY_OK(film);
        for (int i = 0; i < 6; ++i)
            VERIFY_OK(film->add(disc(96, i)));
        VERIFY_OK(film->finish());
        const Result<FilmFacts> facts = filmFacts(at(name));
        VERIFY_OK(facts);
        QCOMPARE(int(facts->frames.size()), 6);
        for (int i = 0; i < 6; ++i) {
            const Image given = disc(96, i);
            double off = 0.0;
            for (int y = 0; y < 96; ++y)
                for (int x = 0; x < 96; ++x)
                    off += std::abs(int(given.at(x, y)[3]) - int(facts->frames[std::size_t(i)].at(x, y)[3]));
            QVERIFY2(off / (96 * 96) < 3.0,
                     qPrintable(QString("%1 frame %2: alpha off by %3").arg(name).arg(i).arg(off / 9216)));
        }
    }
    FilmOptions options;
    options.kind = FilmKind::PngFolder;
    options.width = options.height = 96;
    options.keepsAlpha = true;
    Result<FilmWriter> film = FilmWriter::open(at("pictures"), options);
    VERIFY_OK(film);
    VERIFY_OK(film->add(disc(96, 2)));
    VERIFY_OK(film->finish());
    const Result<Image> back = readPng(at("pictures") / numberedPicture(1));
    VERIFY_OK(back);
    QVERIFY(back->pixels == disc(96, 2).pixels);
}

void FilmWriterTest::noDarkSeamAroundWhatIsVisible()
{
    FilmOptions options;
    options.kind = FilmKind::WebM;
    options.width = options.height = 96;
    options.keepsAlpha = true;
    Result<FilmWriter> film = FilmWriter::open(at("a.webm"), options);
    VERIFY_OK(film);
    VERIFY_OK(film->add(disc(96, 0)));
    VERIFY_OK(film->finish());
    const Result<FilmFacts> facts = filmFacts(at("a.webm"));
    VERIFY_OK(facts);
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x)
            if (const Rgba back = facts->frames[0].at(x, y); back[3] > 60)
                QVERIFY2(back[0] > 190,
                         qPrintable(QString("red is %1 at %2, %3").arg(back[0]).arg(x).arg(y)));
}

void FilmWriterTest::withoutTransparencyOverTheBackground()
{
    FilmOptions options;
    options.width = options.height = 96;
    options.keepsAlpha = true; // H.264 cannot
    options.background = {20, 120, 40, 255};
    Result<FilmWriter> film = FilmWriter::open(at("a.mp4"), options);
    VERIFY_OK(film);
    VERIFY_OK(film->add(disc(96, 0)));
    VERIFY_OK(film->finish());
    const Result<FilmFacts> facts = filmFacts(at("a.mp4"));
    VERIFY_OK(facts);
    const Rgba ground = facts->frames[0].at(90, 8), middle = facts->frames[0].at(32, 48);
    QVERIFY(std::abs(ground[1] - 120) < 6 && ground[0] < 30);
    QVERIFY(middle[0] > 205 && middle[1] < 45);
}

// A film of 2 s; sound: ffmpeg's filter source.
void FilmWriterTest::makeSource(const char *name, const QStringList &sound, const QStringList &codec)
{
    const QStringList arguments =
        QStringList{"-y", "-v", "error", "-f", "lavfi", "-i", "testsrc2=size=64x48:rate=25:duration=2"} +
        sound + codec + QStringList{mFolder->filePath(name)};
    if (QProcess::execute(QStringLiteral("ffmpeg"), arguments) != 0)
        QSKIP("the ffmpeg program, which makes the sources of this test, is not installed");
}

void FilmWriterTest::soundIsKept_data()
{
    QTest::addColumn<QString>("source");
    QTest::addColumn<QStringList>("codec");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("becomes");
    const QStringList x264{"-c:v", "libx264"};
    QTest::newRow("aac is copied") << "s.mp4" << (x264 + QStringList{"-c:a", "aac"}) << "a.mp4"
                                   << "aac";
    QTest::newRow("opus for webm") << "s.mp4" << (x264 + QStringList{"-c:a", "aac"}) << "a.webm"
                                   << "opus";
    QTest::newRow("opus is copied") << "s.webm" << QStringList{"-c:v", "libvpx-vp9", "-c:a", "libopus"}
                                    << "a.webm"
                                    << "opus";
    QTest::newRow("aac for mp4") << "s.mkv" << (x264 + QStringList{"-c:a", "pcm_s16le"}) << "a.mp4"
                                 << "aac";
    QTest::newRow("mp3 is copied") << "s.mp4" << (x264 + QStringList{"-c:a", "libmp3lame"}) << "a.mp4"
                                   << "mp3";
}

void FilmWriterTest::soundIsKept()
{
    QFETCH(QString, source);
    QFETCH(QStringList, codec);
    QFETCH(QString, name);
    QFETCH(QString, becomes);
    makeSource(qPrintable(source), {"-f", "lavfi", "-i", "sine=frequency=440:duration=2", "-shortest"},
               codec);
    FilmOptions options;
    options.kind = *filmKindOf(name.toStdString());
    options.width = 64;
    options.height = 48;
    options.soundFrom = at(qPrintable(source));
    const Result<FilmFacts> facts = written(at(qPrintable(name)), options, 50);
    VERIFY_OK(facts);
    QCOMPARE(int(facts->frames.size()), 50);
    QCOMPARE(QString::fromStdString(facts->soundCodec), becomes);
    QVERIFY2(std::abs(facts->soundSeconds - 2.0) < 0.08, qPrintable(QString::number(facts->soundSeconds)));
    // Half as long: the sound ends with the pictures.
    const Result<FilmFacts> half = written(at(qPrintable(name)), options, 25);
    VERIFY_OK(half);
    QVERIFY2(std::abs(half->soundSeconds - 1.0) < 0.08, qPrintable(QString::number(half->soundSeconds)));
}

void FilmWriterTest::soundStaysInStep()
{
    // Silence, then from one second on a tone. In the new film it begins at the same moment, or half a second
    // earlier if the film begins half a second into the source.
    makeSource("s.mp4", {"-f", "lavfi", "-i", "sine=frequency=440:duration=1", "-af", "adelay=1000"},
               {"-c:v", "libx264", "-c:a", "aac"});
    for (const char *name : {"a.mp4", "a.webm"})
        for (const double begins : {0.0, 0.5}) {
            FilmOptions options;
            options.kind = *filmKindOf(name);
            options.width = 64;
            options.height = 48;
            options.soundFrom = at("s.mp4");
            if (begins > 0.0)
                options.soundBegins = begins;
            const Result<FilmFacts> facts = written(at(name), options, 40);
            VERIFY_OK(facts);
            std::size_t first = 0;
            while (first < facts->sound.size() && std::abs(facts->sound[first]) < 0.02f)
                ++first;
            const double tone = double(first) / facts->soundRate + std::max(0.0, facts->soundBegins);
            QVERIFY2(std::abs(tone - (1.0 - begins)) < 0.05,
                     qPrintable(QString("%1: the tone begins at %2").arg(name).arg(tone)));
        }
}

void FilmWriterTest::aSilentSourceMakesASilentFilm()
{
    makeSource("s.mp4", {}, {"-c:v", "libx264"});
    FilmOptions options;
    options.width = 64;
    options.height = 48;
    options.soundFrom = at("s.mp4");
    const Result<FilmFacts> facts = written(at("a.mp4"), options, 5);
    VERIFY_OK(facts);
    QVERIFY(facts->soundCodec.empty());
    options.soundFrom = at("missing.mp4");
    const Result<FilmFacts> missing = written(at("b.mp4"), options, 5);
    QVERIFY(!missing.ok() && missing.error().code == ErrorCode::FileNotFound);
    QVERIFY(!fs::exists(at("b.mp4")));
}

void FilmWriterTest::oneFrame()
{
    for (const char *name : {"a.mp4", "a.webm", "a.gif"}) {
        FilmOptions options;
        options.kind = *filmKindOf(name);
        options.width = 64;
        options.height = 48;
        const Result<FilmFacts> facts = written(at(name), options, 1);
        VERIFY_OK(facts);
        QCOMPARE(int(facts->frames.size()), 1);
        QVERIFY2(std::abs(facts->seconds - 0.04) < 0.0015, qPrintable(QString::number(facts->seconds)));
    }
}

void FilmWriterTest::nothingIsLeftOfAFilmThatWasNotFinished_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name : {"a.mp4", "a.webm", "a.gif", "pictures"})
        QTest::newRow(name) << name;
}

void FilmWriterTest::nothingIsLeftOfAFilmThatWasNotFinished()
{
    QFETCH(QString, name);
    FilmOptions options;
    options.kind = *filmKindOf(name.toStdString());
    options.width = 64;
    options.height = 48;
    {
        Result<FilmWriter> film = FilmWriter::open(at(qPrintable(name)), options);
        VERIFY_OK(film);
        for (int i = 0; i < 30; ++i)
            VERIFY_OK(film->add(picture(64, 48, i)));
        QVERIFY(entryCount() == 1); // under another name
        QVERIFY(!fs::exists(at(qPrintable(name))));
    }
    QCOMPARE(entryCount(), 0);
    {
        Result<FilmWriter> film = FilmWriter::open(at(qPrintable(name)), options);
        VERIFY_OK(film);
        QVERIFY(!film->finish().ok()); // without a frame
    }
    QCOMPARE(entryCount(), 0);
}

void FilmWriterTest::anOlderFilmStaysUntilTheNewOneIsThere()
{
    FilmOptions options;
    options.width = 64;
    options.height = 48;
    VERIFY_OK(written(at("a.mp4"), options, 5));
    {
        Result<FilmWriter> film = FilmWriter::open(at("a.mp4"), options);
        VERIFY_OK(film);
        VERIFY_OK(film->add(picture(64, 48, 0)));
        QVERIFY(!film->add(picture(64, 50, 0)).ok());
    }
    QCOMPARE(int(filmFacts(at("a.mp4"))->frames.size()), 5);
    const Result<FilmFacts> facts = written(at("a.mp4"), options, 8);
    VERIFY_OK(facts);
    QCOMPARE(int(facts->frames.size()), 8);
    QCOMPARE(entryCount(), 1);
}

void FilmWriterTest::foldersWithOtherFilesAreLeftAlone()
{
    FilmOptions options;
    options.kind = FilmKind::PngFolder;
    options.width = 16;
    options.height = 16;
    for (const int count : {4, 2}) { // an earlier film is replaced
        Result<FilmWriter> film = FilmWriter::open(at("pictures"), options);
        VERIFY_OK(film);
        for (int i = 0; i < count; ++i)
            VERIFY_OK(film->add(picture(16, 16, i)));
        VERIFY_OK(film->finish());
        QCOMPARE(QDir(mFolder->filePath("pictures")).entryList(QDir::Files).size(), qsizetype(count));
    }
    QVERIFY(writePng(picture(4, 4, 0), at("pictures") / "holiday.png").ok());
    const Result<FilmWriter> refused = FilmWriter::open(at("pictures"), options);
    QVERIFY(!refused.ok());
    QVERIFY(refused.error().problem.find("holiday.png") != std::string::npos);
    QVERIFY(fs::exists(at("pictures") / "holiday.png"));
    QCOMPARE(entryCount(), 1);
}

void FilmWriterTest::whatCannotBeWrittenIsSaid()
{
    FilmOptions options;
    options.width = 64;
    options.height = 48;
    const auto codeFor = [&](const fs::path &path) {
        const Result<FilmWriter> film = FilmWriter::open(path, options);
        return film.ok() ? ErrorCode::NoSolution : film.error().code;
    };
    QCOMPARE(codeFor(at("missing") / "a.mp4"), ErrorCode::FileNotFound);
    QVERIFY(fs::create_directory(at("folder.mp4")));
    QCOMPARE(codeFor(at("folder.mp4")), ErrorCode::NotAFile);
    options.width = 0;
    QCOMPARE(codeFor(at("a.mp4")), ErrorCode::InvalidArgument);
    options.width = 64;
    options.rate = {0, 1};
    QCOMPARE(codeFor(at("a.mp4")), ErrorCode::InvalidArgument);
    options.rate = {25, 1};
    options.frameTimes = {0.0, 0.5, 0.5};
    QCOMPARE(codeFor(at("a.mp4")), ErrorCode::InvalidArgument);
    options.frameTimes = {0.0};
    Result<FilmWriter> film = FilmWriter::open(at("a.mp4"), options);
    VERIFY_OK(film);
    VERIFY_OK(film->add(picture(64, 48, 0)));
    QVERIFY(!film->add(picture(64, 48, 1)).ok()); // no time for it
    VERIFY_OK(film->finish());                    // what was refused changed nothing
    QCOMPARE(int(filmFacts(at("a.mp4"))->frames.size()), 1);
}

QTEST_APPLESS_MAIN(FilmWriterTest)
#include "film_writer_test.moc"
