#include <nlohmann/json.hpp>

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

class ReconstructionSmokeTest : public QObject
{
    Q_OBJECT
private slots:
    void quickRunGivesSaneNumbers()
    {
        const QTemporaryDir folder;
        const QString json = folder.filePath("report.json");
        QProcess process;
        process.start(DUCTUS_BENCH_RECONSTRUCTION, {"--quick", "--json", json});
        QVERIFY(process.waitForFinished(280000));
        QCOMPARE(process.exitCode(), 0);
        QFile file(json);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const auto report = nlohmann::json::parse(file.readAll().toStdString());
        const auto &rows = report.at("synthetic").at("rows");
        QCOMPARE(rows.size(), std::size_t(2));
        QVERIFY(rows[0].at("rung") == "solved");
        QVERIFY(rows[0].at("path").get<double>() < 2.0);
        QVERIFY(rows[0].at("depth").get<double>() < 8.0);
        QVERIFY(rows[1].at("rung") == "rotation");
        QVERIFY(rows[1].at("turn").get<double>() < 1.0);
    }
    void wrongUsageIsSaid()
    {
        QProcess process;
        process.start(DUCTUS_BENCH_RECONSTRUCTION, {"--nonsense"});
        QVERIFY(process.waitForFinished(20000));
        QCOMPARE(process.exitCode(), 2);
    }
};

QTEST_GUILESS_MAIN(ReconstructionSmokeTest)
#include "reconstruction_smoke_test.moc"
