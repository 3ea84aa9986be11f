#include "sketchsurfacer/cli/surface_arguments.h"

#include <QtTest>

using namespace ductus;

class SurfaceArgumentsTest : public QObject
{
    Q_OBJECT
private slots:
    void defaultsAreThoseOfTheEngine();
    void everyOptionArrives();
    void givenOptionsGoOverStoredOnes();
    void planes_data();
    void planes();
    void strokeLists_data();
    void strokeLists();
    void helpNamesTheRealDefaults();
};

namespace {

ParsedSurfaceArguments parse(const QString &text)
{
    return parseSurfaceArguments(text.split(QLatin1Char(' '), Qt::SkipEmptyParts));
}

} // namespace

void SurfaceArgumentsTest::defaultsAreThoseOfTheEngine()
{
    const ParsedSurfaceArguments parsed = parse("in.curves -o out.obj");
    QVERIFY2(parsed.arguments, qPrintable(parsed.message));
    const SurfaceOptions &given = parsed.arguments->options, plain;
    QCOMPARE(given.segmentation.epsilon, plain.segmentation.epsilon);
    QCOMPARE(given.segmentation.simplicity, plain.segmentation.simplicity);
    QCOMPARE(given.segmentation.smoothness, plain.segmentation.smoothness);
    QCOMPARE(given.proxy.targetVertices, plain.proxy.targetVertices);
    QCOMPARE(given.proxy.wrap.tightness, plain.proxy.wrap.tightness);
    QCOMPARE(given.segmentation.runs, 1);
    QCOMPARE(int(given.symmetry), int(SymmetryMode::None));
    QVERIFY(parsed.arguments->report.empty() && parsed.arguments->picture.empty() &&
            parsed.arguments->proxy.empty());
    QVERIFY(parsed.arguments->boundaryStrokes.empty() && parsed.arguments->ignoredStrokes.empty() &&
            parsed.arguments->skeletalStrokes.empty());
    QCOMPARE(given.skeletal.radius, plain.skeletal.radius);
    QVERIFY(parsed.arguments->findCables);
    QVERIFY(!parse("in.curves -o out.obj --parts some").arguments);
    QVERIFY(!parsed.arguments->quiet);
}

void SurfaceArgumentsTest::everyOptionArrives()
{
    const ParsedSurfaceArguments parsed = parse(
        "in.curves more.obj -o out.PLY --scribbles s.json --proxy m.stl --symmetry auto --epsilon 0.02 "
        "--simplicity 0.5 --smoothness 3 "
        "--runs 10 --seed 9007199254740991 --proxy-vertices 5000 --tightness 0.25 --boundary 3 --ignore "
        "5,7-9 --skeletal 2,4-5 --tube-radius 0.02 --parts off "
        "--report r.json --picture p.PNG --ambiguity a.json -q");
    QVERIFY2(parsed.arguments, qPrintable(parsed.message));
    const SurfaceArguments &a = *parsed.arguments;
    QCOMPARE(a.inputs, (std::vector<std::filesystem::path>{"in.curves", "more.obj"}));
    QCOMPARE(a.scribbles, std::filesystem::path("s.json"));
    QCOMPARE(a.skeletalStrokes, (std::vector<int>{2, 4, 5}));
    QCOMPARE(a.options.skeletal.radius, 0.02);
    QVERIFY(!a.findCables);
    QCOMPARE(a.output, std::filesystem::path("out.PLY"));
    QCOMPARE(a.proxy, std::filesystem::path("m.stl"));
    QCOMPARE(a.report, std::filesystem::path("r.json"));
    QCOMPARE(a.picture, std::filesystem::path("p.PNG"));
    QCOMPARE(a.ambiguity, std::filesystem::path("a.json"));
    QCOMPARE(int(a.options.symmetry), int(SymmetryMode::Auto));
    QCOMPARE(a.options.segmentation.epsilon, 0.02);
    QCOMPARE(a.options.segmentation.simplicity, 0.5);
    QCOMPARE(a.options.segmentation.smoothness, 3.0);
    QCOMPARE(a.options.segmentation.runs, 10);
    QCOMPARE(a.options.segmentation.seed, std::uint64_t(9007199254740991));
    QCOMPARE(a.options.proxy.targetVertices, 5000);
    QCOMPARE(a.options.proxy.wrap.tightness, 0.25);
    QCOMPARE(a.boundaryStrokes, std::vector<int>{3});
    QCOMPARE(a.ignoredStrokes, (std::vector<int>{5, 7, 8, 9}));
    QVERIFY(a.quiet);
}

void SurfaceArgumentsTest::givenOptionsGoOverStoredOnes()
{
    SurfaceOptions stored;
    stored.segmentation.runs = 7;
    stored.segmentation.epsilon = 0.05;
    stored.symmetry = SymmetryMode::Auto;
    const ParsedSurfaceArguments parsed = parse("in.ductus -o out.ductus --epsilon 0.02 --symmetry none");
    QVERIFY2(parsed.arguments, qPrintable(parsed.message));
    parsed.arguments->given.applyTo(stored);
    QCOMPARE(stored.segmentation.epsilon, 0.02);
    QCOMPARE(stored.segmentation.runs, 7);
    QCOMPARE(int(stored.symmetry), int(SymmetryMode::None));
}

void SurfaceArgumentsTest::planes_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QList<double>>("plane"); // nx, ny, nz, offset; empty: refused
    QTest::newRow("axis") << "y" << QList<double>{0, 1, 0, 0};
    QTest::newRow("capital") << "Z" << QList<double>{0, 0, 1, 0};
    QTest::newRow("made unit") << "0,0,-2,3" << QList<double>{0, 0, -1, 1.5};
    QTest::newRow("slanted") << "3,4,0,10" << QList<double>{0.6, 0.8, 0, 2};
    QTest::newRow("no direction") << "0,0,0,1" << QList<double>{};
    QTest::newRow("infinite") << "inf,0,0,1" << QList<double>{};
    QTest::newRow("too many") << "1,0,0,0,0" << QList<double>{};
    QTest::newRow("empty") << "1,,0,0" << QList<double>{};
}

void SurfaceArgumentsTest::planes()
{
    QFETCH(QString, text);
    QFETCH(QList<double>, plane);
    const ParsedSurfaceArguments parsed = parse("in.curves -o out.obj --symmetry " + text);
    QCOMPARE(parsed.arguments.has_value(), !plane.isEmpty());
    if (plane.isEmpty()) {
        QVERIFY(parsed.message.contains("--symmetry"));
        return;
    }
    QCOMPARE(int(parsed.arguments->options.symmetry), int(SymmetryMode::Given));
    const SymmetryPlane &given = parsed.arguments->options.symmetryPlane;
    QVERIFY((given.normal - Vec3(plane[0], plane[1], plane[2])).norm() < 1e-15);
    QVERIFY(std::abs(given.offset - plane[3]) < 1e-15);
}

void SurfaceArgumentsTest::strokeLists_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("isGood");
    for (const char *good : {"0", "0,4,7-9", "5-5", "0,,1"})
        QTest::newRow(good) << good << true;
    for (const char *bad :
         {",", "-1", "a", "1-", "3-2", "1-2-3", "1.5", "0x3", "99999999999", "0-1999999999"})
        QTest::newRow(bad) << bad << false;
}

void SurfaceArgumentsTest::strokeLists()
{
    QFETCH(QString, text);
    QFETCH(bool, isGood);
    const ParsedSurfaceArguments parsed = parse("in.curves -o out.obj --boundary=" + text);
    QCOMPARE(parsed.arguments.has_value(), isGood);
    QVERIFY(isGood || parsed.message.contains("--boundary"));
}

void SurfaceArgumentsTest::helpNamesTheRealDefaults()
{
    const ParsedSurfaceArguments parsed = parse("--help");
    QVERIFY(parsed.isHelp && !parsed.arguments);
    const SurfaceOptions plain;
    const QString help = parsed.message.simplified(); // it is wrapped to the width of a terminal
    for (double value :
         {plain.segmentation.epsilon, plain.segmentation.simplicity, plain.segmentation.smoothness,
          double(plain.proxy.targetVertices), double(plain.segmentation.seed)})
        QVERIFY2(help.contains(QStringLiteral("Default: %1.").arg(value)),
                 qPrintable(QString::number(value)));
}

QTEST_APPLESS_MAIN(SurfaceArgumentsTest)
#include "surface_arguments_test.moc"
