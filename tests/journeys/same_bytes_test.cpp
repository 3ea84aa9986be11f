// "I ran it again and got another mesh": the same sketch and seed give the same bytes, on any number of
// cores.
#include "journeys/sketch_journey.h"

#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

#include <nlohmann/json.hpp>

using namespace ductus;
using Json = nlohmann::ordered_json;

class SameBytesTest : public QObject
{
    Q_OBJECT
private slots:
    void sameSeedSameBytes();
    void anotherSeedIsReported();
};

namespace {

struct Outcome
{
    QByteArray mesh, picture;
    std::string report; // without the timings
};

Outcome outcomeOf(const QString &folder, const QString &name, const QStringList &more,
                  const RunOptions &options, QByteArray &problem)
{
    const QString stem = QDir(folder).filePath(name);
    const ProgramRun run = runSketchSurfacer(
        surfaceArguments(samplePath(QStringLiteral("computer-mouse")), stem + ".obj",
                         QStringList{"--report", stem + ".json", "--picture", stem + ".png"} + more),
        options);
    if (run.exitCode != 0)
        problem = run.told();
    Json report = Json::parse(bytesOf(stem + ".json").toStdString(), nullptr, false);
    if (report.is_object())
        report.erase("seconds");
    return {bytesOf(stem + ".obj"), bytesOf(stem + ".png"), report.dump(1)};
}

} // namespace

void SameBytesTest::sameSeedSameBytes()
{
    QTemporaryDir folder;
    QByteArray problem;
    const QStringList several = {"--runs", "3", "--seed", "7"};
    const Outcome first = outcomeOf(folder.path(), "first", several, {}, problem);
    QVERIFY2(problem.isEmpty(), problem.constData());
    QVERIFY(!first.mesh.isEmpty() && !first.picture.isEmpty());
    const Outcome again = outcomeOf(folder.path(), "again", several, {}, problem);
    QVERIFY2(problem.isEmpty(), problem.constData());
    QVERIFY(first.mesh == again.mesh);
    QVERIFY(first.picture == again.picture);
    QCOMPARE(QString::fromStdString(first.report), QString::fromStdString(again.report));

    if (QStandardPaths::findExecutable("taskset").isEmpty())
        QSKIP("taskset is not installed: the comparison with one core is left out");
    RunOptions oneCore;
    oneCore.prefix = QStringList{"taskset", "-c", "0"};
    const Outcome alone = outcomeOf(folder.path(), "alone", several, oneCore, problem);
    QVERIFY2(problem.isEmpty(), problem.constData());
    QVERIFY2(first.mesh == alone.mesh, "one core gives another mesh than all");
    QVERIFY(first.picture == alone.picture);
    QCOMPARE(QString::fromStdString(first.report), QString::fromStdString(alone.report));
}

void SameBytesTest::anotherSeedIsReported()
{
    QTemporaryDir folder;
    QByteArray problem;
    const Outcome seven = outcomeOf(folder.path(), "seven", {"--seed", "7"}, {}, problem);
    const Outcome eight = outcomeOf(folder.path(), "eight", {"--seed", "8"}, {}, problem);
    QVERIFY2(problem.isEmpty(), problem.constData());
    QVERIFY2(seven.report != eight.report, "the seed does nothing, or the comparison above proves nothing");
    QCOMPARE(Json::parse(eight.report).at("options").at("seed").get<int>(), 8);
}

QTEST_GUILESS_MAIN(SameBytesTest)
#include "same_bytes_test.moc"
