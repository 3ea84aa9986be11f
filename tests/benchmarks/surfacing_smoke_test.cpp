// The benchmark program runs from its command line to its report, and two solids come out near their truth.
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

namespace {

struct Outcome
{
    int exitCode = -1;
    QByteArray output, errors;
};

Outcome runBench(const QStringList &arguments)
{
    QProcess process;
    process.start(DUCTUS_BENCH_SURFACING, arguments);
    if (!process.waitForFinished(550'000 /* a busy machine */)) {
        process.kill();
        return {};
    }
    if (process.exitStatus() != QProcess::NormalExit)
        return {};
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

} // namespace

class SurfacingSmokeTest : public QObject
{
    Q_OBJECT
private slots:
    void twoSolidsComeOutNearTheirTruth();
    void wrongUsageIsExplained_data();
    void wrongUsageIsExplained();
    void aReportWithoutAFolderFailsAtOnce();
    void noReportIsNeeded();
};

void SurfacingSmokeTest::twoSolidsComeOutNearTheirTruth()
{
    QTemporaryDir folder;
    const QString file = folder.filePath("report.json");
    const Outcome outcome = runBench({"--quick", "--only", "truth", "--solids", "can,torus", "--json", file});
    QVERIFY2(outcome.exitCode == 0, outcome.errors.constData());
    QVERIFY2(outcome.output.contains("can ") && outcome.output.contains("torus "),
             outcome.output.constData());

    std::ifstream stream(file.toStdString());
    const nlohmann::json report = nlohmann::json::parse(stream, nullptr, false);
    QVERIFY(report.is_object());
    const nlohmann::json rows = report.at("truth").at("rows");
    QCOMPARE(rows.size(), std::size_t(2));
    QCOMPARE(report.size(), std::size_t(1)); // --only
    for (const nlohmann::json &row : rows) {
        for (const char *key : {"resultToTruthMedian", "truthToResultMedian", "strokeMedian"}) {
            const double median = row.at(key).get<double>();
            QVERIFY2(median > 0.0 && median < 1.0, qPrintable(QString("%1 is %2 %").arg(key).arg(median)));
        }
        for (const char *key : {"creaseRecall", "creasePrecision"}) {
            const double share = row.at(key).get<double>();
            QVERIFY(share >= 0.0 && share <= 1.0);
        }
        QVERIFY(row.at("regions").get<double>() >= 1.0);
        QVERIFY(row.at("segmentationSeconds").get<double>() > 0.0);
        // The verdict is about the worse direction.
        const double worse = std::max(row.at("resultToTruthMedian").get<double>(),
                                      row.at("truthToResultMedian").get<double>());
        QCOMPARE(row.at("verdict").get<std::string>(), std::string(worse <= 0.3 ? "OK" : "MISS"));
    }
}

void SurfacingSmokeTest::wrongUsageIsExplained_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("complaint");
    QTest::newRow("unknown option") << QStringList{"--fast", "1"} << "'--fast' is unknown";
    QTest::newRow("unknown section") << QStringList{"--only", "beauty"} << "there is no section 'beauty'";
    QTest::newRow("unknown solid") << QStringList{"--solids", "torus,teapot"} << "there is no solid 'teapot'";
    QTest::newRow("no value") << QStringList{"--json"} << "lacks its value";
    QTest::newRow("no number") << QStringList{"--runs", "3x"} << "--runs needs a number above 0";
    QTest::newRow("zero runs") << QStringList{"--runs", "0"} << "--runs needs a number above 0";
}

void SurfacingSmokeTest::wrongUsageIsExplained()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, complaint);
    const Outcome outcome = runBench(arguments);
    QCOMPARE(outcome.exitCode, 2);
    QVERIFY2(outcome.errors.contains(complaint.toUtf8()), outcome.errors.constData());
    QVERIFY(outcome.output.isEmpty());
}

void SurfacingSmokeTest::aReportWithoutAFolderFailsAtOnce()
{
    QTemporaryDir folder;
    const QString file = folder.filePath("nowhere/report.json");
    const Outcome outcome = runBench({"--quick", "--only", "truth", "--solids", "torus", "--json", file});
    QCOMPARE(outcome.exitCode, 1);
    QVERIFY2(outcome.errors.contains("Writing the report failed"), outcome.errors.constData());
    QVERIFY(outcome.output.isEmpty()); // before anything was measured
}

void SurfacingSmokeTest::noReportIsNeeded()
{
    // The sweeps leave out the torus, so that only their headings are printed.
    const Outcome outcome = runBench({"--only", "sweeps", "--solids", "torus"});
    QVERIFY2(outcome.exitCode == 0, outcome.errors.constData());
    QCOMPARE(outcome.output.count("SWEEPS:"), 3);
}

QTEST_APPLESS_MAIN(SurfacingSmokeTest)
#include "surfacing_smoke_test.moc"
