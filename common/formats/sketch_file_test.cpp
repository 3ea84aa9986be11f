#include "formats/sketch_file.h"

#include <QtTest>
#include <chrono>
#include <cmath>
#include <fstream>

using namespace ductus;

namespace {

Result<SketchFile> parse(const std::string &text, const std::string &name, int maxPoints = 4'000'000)
{
    return parseSketch(text, name, {maxPoints}, {});
}

std::size_t strokeCount(const Result<SketchFile> &file)
{
    return file ? file->strokes.strokes.size() : 0;
}

} // namespace

class SketchFileTest : public QObject
{
    Q_OBJECT
private slots:
    void curvesKeepEveryBitAndOrder();
    void lineEndsTabsAndMarksDoNotMatter_data();
    void lineEndsTabsAndMarksDoNotMatter();
    void kindIsToldFromContent_data();
    void kindIsToldFromContent();
    void wrongInputNamesLineAndReason_data();
    void wrongInputNamesLineAndReason();
    void everyPrefixOfAFileIsReadOrRefused();
    void onePointStrokesAreSkippedWithAWarning();
    void objPolylinesStayAsTheyAreAndSegmentsAreChained();
    void segmentsWithVerticesOfTheirOwnAreJoined();
    void repeatedSegmentsCountOnce();
    void continuedObjLinesAreOne();
    void shuffledPointsAreACloudAndStrokesAreNot();
    void missingFileAndFolderAreToldApart();
    void tenMillionPointsAreRefusedQuickly();
    void cancelEndsReading();
};

void SketchFileTest::curvesKeepEveryBitAndOrder()
{
    const auto file = parse("v 3\n0.1 -2e-3 +3\n4 5 6\n1e-400 0 -0\nv 2\n7 8 9\n10 11 12\n", "a.curves");
    QVERIFY2(file, file ? "" : file.error().message().c_str());
    QCOMPARE(file->kind, SketchFileKind::Curves);
    QCOMPARE(strokeCount(file), std::size_t(2));
    const Stroke &first = file->strokes.strokes[0];
    QVERIFY(first.points[0] == Vec3(0.1, -2e-3, 3.0));
    QVERIFY(first.points[2] == Vec3(0, 0, 0));
    QCOMPARE(file->strokes.strokes[1].id.value, 1);
    QVERIFY(file->warnings.empty());
}

void SketchFileTest::lineEndsTabsAndMarksDoNotMatter_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("unix") << QByteArray("v 2\n1 2 3\n4 5 6\n");
    QTest::newRow("windows") << QByteArray("v 2\r\n1 2 3\r\n4 5 6\r\n");
    QTest::newRow("old mac") << QByteArray("v 2\r1 2 3\r4 5 6\r");
    QTest::newRow("mixed") << QByteArray("v 2\r\n1 2 3\r4 5 6\n");
    QTest::newRow("no last end") << QByteArray("v 2\n1 2 3\n4 5 6");
    QTest::newRow("tabs and blanks") << QByteArray("  v\t2 \n\t1\t2   3\t\n4 5 6 \n\n");
    QTest::newRow("byte order mark") << QByteArray("\xEF\xBB\xBFv 2\n1 2 3\n4 5 6\n");
    QTest::newRow("comments") << QByteArray("# a\n\nv 2\n# b\n1 2 3\n\n4 5 6\n");
}

void SketchFileTest::lineEndsTabsAndMarksDoNotMatter()
{
    QFETCH(QByteArray, text);
    const auto file = parse(text.toStdString(), "a.curves");
    QVERIFY2(file, file ? "" : file.error().message().c_str());
    QCOMPARE(strokeCount(file), std::size_t(1));
    QVERIFY(file->strokes.allPoints() == (std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}}));
}

void SketchFileTest::kindIsToldFromContent_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("kind");
    QTest::newRow("curves named obj")
        << QByteArray("v 2\n1 2 3\n4 5 6\n") << "a.obj" << int(SketchFileKind::Curves);
    QTest::newRow("obj named curves")
        << QByteArray("v 1 2 3\nv 4 5 6\nl 1 2\n") << "a.curves" << int(SketchFileKind::ObjLines);
    QTest::newRow("xyz named curves")
        << QByteArray("1 2 3\n4 5 6\n") << "a.curves" << int(SketchFileKind::Xyz);
    QTest::newRow("curve text") << QByteArray("CURVE 0\n1 2 3\n4 5 6\nCURVE 1\n1 2 3\n4 5 6\n") << "a.txt"
                                << int(SketchFileKind::CurveText);
    QTest::newRow("obj with groups first")
        << QByteArray("# x\ng\nv 1 2 3\nv 4 5 6\ng\nl 1 2\n") << "a.obj" << int(SketchFileKind::ObjLines);
}

void SketchFileTest::kindIsToldFromContent()
{
    QFETCH(QByteArray, text);
    QFETCH(QString, name);
    QFETCH(int, kind);
    const auto file = parse(text.toStdString(), name.toStdString());
    QVERIFY2(file, file ? "" : file.error().message().c_str());
    QCOMPARE(int(file->kind), kind);
}

void SketchFileTest::wrongInputNamesLineAndReason_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("place");
    QTest::addColumn<QString>("words");
    const auto row = [](const char *title, const QByteArray &text, const QString &name, ErrorCode code,
                        const QString &place, const QString &words) {
        QTest::newRow(title) << text << name << int(code) << place << words;
    };
    constexpr ErrorCode bad = ErrorCode::Malformed;
    constexpr ErrorCode little = ErrorCode::TooLittleData;
    row("empty", "", "a.curves", little, "a.curves", "empty");
    row("only blanks", "\n \n\t\n", "a.curves", little, "a.curves", "no strokes");
    row("only comments", "# a\n", "a.obj", little, "a.obj", "no strokes");
    row("too few points", "v 3\n1 2 3\n4 5 6\nv 2\n1 2 3\n4 5 6\n", "a.curves", bad, "a.curves:4",
        "begins at line 1 announces 3 points but only 2");
    row("too many points", "v 1\n1 2 3\n4 5 6\n", "a.curves", bad, "a.curves:3", "expected 'v'");
    row("ends early", "v 3\n1 2 3\n4 5 6\n", "a.curves", bad, "a.curves:3", "announces 3 points but only 2");
    row("negative count", "v -2\n1 2 3\n", "a.curves", bad, "a.curves:1", "negative");
    row("absurd count", "v 99999999999999999999\n1 2 3\n", "a.curves", bad, "a.curves:1", "too large");
    row("large count", "v 999999999\n1 2 3\n", "a.curves", ErrorCode::TooLarge, "a.curves:1", "4000000");
    row("nan", "v 2\n1 2 3\n4 nan 6\n", "a.curves", bad, "a.curves:3", "y coordinate 'nan' is not a finite");
    row("inf", "v 2\n1 2 -inf\n4 5 6\n", "a.curves", bad, "a.curves:2",
        "z coordinate '-inf' is not a finite");
    row("huge", "v 2\n1 2 3\n4 1e400 6\n", "a.curves", bad, "a.curves:3", "too large");
    row("comma", "v 2\n1,5 2 3\n4 5 6\n", "a.curves", bad, "a.curves:2", "'1,5' has a comma");
    row("comma in xyz", "1,5 2,5 3,5\n4 5 6\n", "a.xyz", bad, "a.xyz:1", "comma");
    row("cut in a line", "v 2\n1 2 3\n4 5", "a.curves", bad, "a.curves:3", "2 coordinates instead of 3");
    row("word", "1 2 3\n4 x5 6\n", "a.xyz", bad, "a.xyz:2", "'x5' is not a number");
    row("old mac line numbers", "v 2\r1 2 3\r4 x 6\r", "a.curves", bad, "a.curves:3", "'x' is not a number");
    row("zero bytes", QByteArray("v 2\n1 \0 3\n", 10), "a.curves", bad, "a.curves:2", "binary");
    row("garbage", "\x01\x02\x7f\xff\xc3 garbage\n", "a.curves", bad, "a.curves:1", "");
    row("utf-16", QByteArray("\xFF\xFEv\0 \0", 6), "a.curves", bad, "a.curves", "UTF-16");
    row("zip", "PK\x03\x04 and more", "a.curves", ErrorCode::Unsupported, "a.curves", "zip");
    row("json", "{\"a\": 1}", "a.curves", ErrorCode::Unsupported, "a.curves", "JSON");
    row("mesh", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj", ErrorCode::Unsupported, "a.obj", "mesh");
    row("obj index too high", "v 0 0 0\nv 1 0 0\nl 1 3\n", "a.obj", bad, "a.obj:3",
        "index 3 is out of range");
    row("obj index too low", "v 0 0 0\nv 1 0 0\nl -3 -1\n", "a.obj", bad, "a.obj:3",
        "index -3 is out of range");
    row("obj index zero", "v 0 0 0\nv 1 0 0\nl 0 1\n", "a.obj", bad, "a.obj:3", "counts from 1");
    row("obj line without indices", "v 0 0 0\nl\n", "a.obj", bad, "a.obj:2", "no vertex indices");
    row("obj one-point lines only", "v 0 0 0\nl 1\n", "a.obj", little, "a.obj", "two points");
    row("obj vertex of two", "v 0 0\nv 1 0 0\n", "a.obj", bad, "a.obj:1", "2 coordinates");
    row("only one-point strokes", "v 1\n1 2 3\n", "a.curves", little, "a.curves", "two points");
    row("points before CURVE", "CURVE x\n1 2 3\n", "a.txt", bad, "a.txt:1", "number after CURVE");
}

void SketchFileTest::wrongInputNamesLineAndReason()
{
    QFETCH(QByteArray, text);
    QFETCH(QString, name);
    QFETCH(int, code);
    QFETCH(QString, place);
    QFETCH(QString, words);
    const auto file = parse(text.toStdString(), name.toStdString());
    QVERIFY(!file.ok());
    const QString message = QString::fromStdString(file.error().message());
    QVERIFY2(int(file.error().code) == code, qPrintable(message));
    QCOMPARE(QString::fromStdString(file.error().place), place);
    QVERIFY2(message.contains(words), qPrintable(message));
    QVERIFY2(!file.error().remedy.empty(), "each error says what to do");
}

void SketchFileTest::everyPrefixOfAFileIsReadOrRefused()
{
    const std::string whole = "v 3\n0.25 1 2\n3 4 5\n6 7 8.5\nv 2\n9 10 11\n12 13 14\n";
    int read = 0;
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const auto file = parse(whole.substr(0, length), "a.curves");
        read += file.ok();
        if (!file)
            QVERIFY(!file.error().place.empty());
        else // never more than was there, never a stroke shorter than announced
            QVERIFY(file->strokes.pointCount() == 3 || file->strokes.pointCount() == 5);
    }
    QVERIFY(read > 0);
    QCOMPARE(strokeCount(parse(whole, "a.curves")), std::size_t(2));
}

void SketchFileTest::onePointStrokesAreSkippedWithAWarning()
{
    const auto file = parse("v 1\n1 2 3\nv 2\n1 2 3\n4 5 6\nv 0\n", "hat.curves");
    QVERIFY(file.ok());
    QCOMPARE(strokeCount(file), std::size_t(1));
    QCOMPARE(file->warnings.size(), std::size_t(2));
    QCOMPARE(file->warnings[0], std::string("hat.curves:1: a stroke of one point was skipped"));
    QCOMPARE(file->warnings[1], std::string("hat.curves:6: a stroke without points was skipped"));
}

void SketchFileTest::objPolylinesStayAsTheyAreAndSegmentsAreChained()
{
    const auto file = parse("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nl 1 2 3\nl -2/5 -1/6\nl 2\n", "a.obj");
    QVERIFY2(file, file ? "" : file.error().message().c_str());
    QCOMPARE(strokeCount(file), std::size_t(2));
    QVERIFY(file->strokes.strokes[0].points == (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}));
    QVERIFY(file->strokes.strokes[1].points == (std::vector<Vec3>{{2, 0, 0}, {3, 0, 0}}));
    QCOMPARE(file->warnings.size(), std::size_t(1));
}

void SketchFileTest::segmentsWithVerticesOfTheirOwnAreJoined()
{
    const auto file =
        parse("v 0 0 0\nv 1 0 0\nv 1 0 0\nv 1 1 0\nv 1 1 0\nv 0 0 0\nl 1 2\nl 3 4\nl 5 6\n", "a.obj");
    QVERIFY(file.ok());
    QCOMPARE(strokeCount(file), std::size_t(1));
    QVERIFY(file->strokes.strokes[0].points ==
            (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}})); // closed: first == last
}

void SketchFileTest::repeatedSegmentsCountOnce()
{
    const auto file = parse("v 0 0 0\nv 1 0 0\nv 2 0 0\nl 1 2\nl 2 3\nl 3 2\nl 1 2\n", "a.obj");
    QVERIFY(file.ok());
    QCOMPARE(strokeCount(file), std::size_t(1));
    QCOMPARE(file->strokes.pointCount(), 3);
    QCOMPARE(file->warnings.size(), std::size_t(1));
}

void SketchFileTest::continuedObjLinesAreOne()
{
    const auto file = parse("v 0 0 0\nv 1 0 0\nv 2 0 0\nl 1 2\\\n 3\n", "a.obj");
    QVERIFY(file.ok());
    QCOMPARE(file->strokes.strokes[0].points.size(), std::size_t(3));
}

void SketchFileTest::shuffledPointsAreACloudAndStrokesAreNot()
{
    std::vector<std::string> lines;
    for (int i = 0; i < 400; ++i)
        lines.push_back(std::to_string(std::cos(i * 0.05)) + " " + std::to_string(std::sin(i * 0.05)) + " " +
                        std::to_string(i * 0.002) + "\n");
    std::string ordered, shuffled;
    for (int i = 0; i < 400; ++i) {
        ordered += lines[std::size_t(i)];
        shuffled += lines[std::size_t(i * 173 % 400)]; // 173 has no factor in common with 400
    }
    const auto stroke = parse(ordered, "a.xyz");
    QVERIFY(stroke.ok());
    QVERIFY(!stroke->isPointCloud);
    QCOMPARE(strokeCount(stroke), std::size_t(1));
    const auto cloud = parse(shuffled, "a.xyz");
    QVERIFY(cloud.ok());
    QVERIFY(cloud->isPointCloud);
    QCOMPARE(strokeCount(cloud), std::size_t(400));
    QCOMPARE(cloud->strokes.pointCount(), 400);
    // Blank lines say where strokes end, so those files are never clouds.
    const auto blocks = parse("0 0 0\n1 0 0\n\n\n0 1 0\n1 1 0\n", "a.xyz");
    QVERIFY(blocks.ok());
    QVERIFY(!blocks->isPointCloud);
    QCOMPARE(strokeCount(blocks), std::size_t(2));
}

void SketchFileTest::missingFileAndFolderAreToldApart()
{
    QTemporaryDir folder;
    const std::filesystem::path path = folder.path().toStdString();
    QCOMPARE(readSketch(path / "none.curves", {}, {}).error().code, ErrorCode::FileNotFound);
    QCOMPARE(readSketch(path, {}, {}).error().code, ErrorCode::NotAFile);
    QCOMPARE(readSketch("/dev/null", {}, {}).error().code, ErrorCode::NotAFile);
    std::ofstream(path / "empty.curves").close();
    QCOMPARE(readSketch(path / "empty.curves", {}, {}).error().code, ErrorCode::TooLittleData);
    std::ofstream(path / "größe.curves") << "v 2\n1 2 3\n4 5 6\n";
    QCOMPARE(strokeCount(readSketch(path / "größe.curves", {}, {})), std::size_t(1));
}

void SketchFileTest::tenMillionPointsAreRefusedQuickly()
{
    QTemporaryDir folder;
    const std::filesystem::path path = std::filesystem::path(folder.path().toStdString()) / "many.xyz";
    {
        std::ofstream file(path);
        std::string block;
        for (int i = 0; i < 10'000; ++i)
            block += "0.12345 1.2345 " + std::to_string(i) + "\n";
        for (int i = 0; i < 1000; ++i)
            file << block;
    }
    const auto start = std::chrono::steady_clock::now();
    const auto result = readSketch(path, {500'000}, {});
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    QVERIFY(!result.ok());
    QCOMPARE(result.error().code, ErrorCode::TooLarge);
    QCOMPARE(result.error().place, std::string("many.xyz:500001"));
    QVERIFY(result.error().message().find("500000") != std::string::npos);
    // Reading stops at the limit: twenty times the points must not take twenty times the time.
    QVERIFY2(seconds < 3.0, std::to_string(seconds).c_str());
}

void SketchFileTest::cancelEndsReading()
{
    std::string text = "v 100000\n";
    for (int i = 0; i < 100000; ++i)
        text += "1 2 3\n";
    std::atomic<bool> cancelled = false;
    const JobControl control(&cancelled,
                             [&](double fraction, std::string_view) { cancelled = fraction > 0.2; });
    const auto file = parseSketch(text, "a.curves", {}, control);
    QVERIFY(!file.ok());
    QVERIFY(file.error().isCancelled());
}

QTEST_APPLESS_MAIN(SketchFileTest)
#include "sketch_file_test.moc"
