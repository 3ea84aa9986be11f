// Actions and their log: every action goes to text and back, plays the same again, and refuses in words.
#include "painting/action/action_log.h"

#include "painting/scene/painting_check.h"
#include "painting/testing/random_actions.h"
#include "painting/testing/sample_painting.h"

#include <QtTest>

#include <set>

using namespace ductus;

namespace {

Result<Painting> noSource(const std::string &source)
{
    return Error{ErrorCode::FileNotFound, "Opening", "there is none", "", source};
}

Result<std::vector<LogEntry>> parsed(const std::string &text)
{
    return parsedLog(text, "a.jsonl");
}

Result<Painting> play(const std::string &text)
{
    const auto log = parsed(text);
    if (!log)
        return log.error();
    return replayed(*log, "a.jsonl", noSource, {});
}

QByteArray messageOf(const Result<Painting> &result)
{
    return result.ok() ? QByteArray() : QByteArray::fromStdString(result.error().message());
}

} // namespace

class ActionLogTest : public QObject
{
    Q_OBJECT
private slots:
    void randomSessionsComeOutTheSame();
    void everyActionWasPlayed();
    void writesWhatItSays();
    void playsAScriptWrittenByHand();
    void cutsStrokesAndKeepsGroups();
    void refusalsNameTheLine_data();
    void refusalsNameTheLine();
    void startsFromAPainting();
    void stopsStepByStep();
    void theManualHasAnExampleOfEveryAction();

private:
    std::set<std::string_view> mSeen;
};

void ActionLogTest::randomSessionsComeOutTheSame()
{
    int accepted = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        Random random(seed);
        const Painting start = samplePainting(seed, 3, 4);
        Painting painting = start;
        std::vector<Painting> history{painting};
        std::size_t present = 0;
        std::string text =
            logLine({"2026-01-01T00:00:00.000Z", LogStart{"sample", paintingFingerprint(start)}}) + "\n";
        for (int step = 0; step < 150; ++step) {
            if (random.index(8) == 0 && present > 0) {
                --present;
                text += logLine({"", LogUndo()}) + "\n";
            } else if (random.index(8) == 0 && present + 1 < history.size()) {
                ++present;
                text += logLine({"", LogRedo()}) + "\n";
            } else {
                const PaintingAction action = randomAction(history[present], random);
                Result<PerformedAction> result = performed(history[present], action);
                if (!result) {
                    QVERIFY(!result.error().problem.empty() && !result.error().remedy.empty());
                    continue;
                }
                QVERIFY(checkPainting(result->painting).ok());
                ++accepted;
                mSeen.insert(actionWord(action));
                text += logLine({"", action, result->made}) + "\n";
                history.resize(present + 1);
                history.push_back(std::move(result->painting));
                ++present;
            }
        }
        const auto log = parsed(text);
        QVERIFY2(log.ok(), log.ok() ? "" : log.error().message().c_str());
        const auto again =
            replayed(*log, "a.jsonl", [&](const std::string &) { return Result<Painting>(start); }, {});
        QVERIFY2(again.ok(), again.ok() ? "" : again.error().message().c_str());
        QCOMPARE(paintingFingerprint(*again), paintingFingerprint(history[present]));
        // Text, read and written again, is the same text.
        std::string rewritten;
        for (const LogEntry &entry : *log)
            rewritten += logLine(entry) + "\n";
        QCOMPARE(QByteArray::fromStdString(rewritten), QByteArray::fromStdString(text));
    }
    QVERIFY(accepted > 800);
}

void ActionLogTest::everyActionWasPlayed()
{
    QCOMPARE(mSeen.size(), std::variant_size_v<PaintingAction>);
}

void ActionLogTest::writesWhatItSays()
{
    act::SetProperties edit;
    edit.layer = LayerId{5};
    edit.opacity = 0.5;
    edit.blend = BlendMode::SoftLight;
    QCOMPARE(
        QByteArray::fromStdString(logLine({"2026-05-01T10:00:00.250Z", edit})),
        QByteArray("{\"time\": \"2026-05-01T10:00:00.250Z\", \"action\": \"setProperties\", \"objects\": "
                   "{\"layer\": 5}, \"parameters\": {\"opacity\": 0.5, \"blend\": \"soft-light\"}}"));
}

void ActionLogTest::playsAScriptWrittenByHand()
{
    const auto painting = play(
        "{\"action\": \"addStack\", \"objects\": {}, \"parameters\": {\"name\": \"tree\"}}\r\n\n"
        "{\"action\": \"draw\", \"objects\": {\"layer\": 2}, \"parameters\": {\"strokes\": [{\"section\": "
        "\"round\", "
        "\"points\": [[0, 0, 0, 0, 0, 1, 0.1, 0.2, 0.5, 0.1, 1], [0, 1, 0, 0, 0, 1, 0.1, 0.2, 0.5, 0.1, "
        "1]]}]}}\n"
        "{\"action\": \"addLayer\", \"objects\": {\"stack\": 1}, \"parameters\": {\"name\": \"bark\"}}\n"
        "{\"action\": \"duplicate\", \"objects\": {\"elements\": [3], \"layer\": 4}, \"parameters\": "
        "{\"change\": "
        "{\"rotation\": [0, 0, 0, 1], \"scale\": 1, \"mirrored\": false, \"translation\": [0.1, 0, 0]}}}\n"
        "{\"action\": \"undo\"}\n{\"action\": \"redo\"}\n");
    QVERIFY2(painting.ok(), messageOf(painting).constData());
    QCOMPARE(painting->stacks[0].name, std::string("tree"));
    const Element &copy = painting->stacks[0].appearance[0].drawings[0].elements[0];
    QCOMPARE(copy.id.value, 5);
    QCOMPARE(copy.placement.translation.x(), 0.1);
    QCOMPARE(std::get<StrokeShape>(*copy.shape).points[1].position.y(), 1.f);
}

void ActionLogTest::cutsStrokesAndKeepsGroups()
{
    const Painting start = samplePainting(1);
    const Element &stroke = start.stacks[0].substrate->drawings[0].elements[0]; // moved by a group
    const auto cut = performed(start, act::Cut{stroke.id, {{0, 1.5}, {4, 6}}});
    QVERIFY(cut.ok());
    QCOMPARE(cut->made.size(), std::size_t(2));
    const auto &elements = cut->painting.stacks[0].substrate->drawings[0].elements;
    QCOMPARE(elements.size(), std::size_t(6));
    QCOMPARE(elements[0].id.value, cut->made[0]); // in its place
    const auto &first = std::get<StrokeShape>(*elements[0].shape).points;
    const auto &old = std::get<StrokeShape>(*stroke.shape).points;
    QCOMPARE(first.size(), std::size_t(3));
    QVERIFY((first[2].position - 0.5f * (old[1].position + old[2].position)).norm() < 1e-6f);
    QCOMPARE(cut->painting.motionGroups[0].elements.size(), std::size_t(2));
    for (const std::vector<std::pair<double, double>> &wrong :
         {std::vector<std::pair<double, double>>{{2, 1}}, {{0, 2}, {1, 3}}, {{0, 99}}, {{std::nan(""), 2}}})
        QVERIFY(!performed(start, act::Cut{stroke.id, wrong}).ok());
    const auto gone = performed(start, act::Cut{stroke.id, {}});
    QCOMPARE(gone->painting.stacks[0].substrate->drawings[0].elements.size(), std::size_t(4));
    QVERIFY(gone->painting.motionGroups[0].elements.empty());
}

void ActionLogTest::refusalsNameTheLine_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("words");
    QTest::newRow("no JSON") << QByteArray("\n{") << QByteArray("a.jsonl:2");
    QTest::newRow("no object") << QByteArray("[1]") << QByteArray("a.jsonl:1");
    QTest::newRow("unknown action") << QByteArray("{\"action\": \"fly\"}") << QByteArray("no action \"fly\"");
    QTest::newRow("missing field")
        << QByteArray("{\"action\": \"removeLayer\", \"objects\": {}, \"parameters\": {}}")
        << QByteArray("/objects/layer");
    QTest::newRow("no such layer")
        << QByteArray("{\"action\": \"removeLayer\", \"objects\": {\"layer\": 9}, \"parameters\": {}}")
        << QByteArray("no such layer");
    QTest::newRow("undo") << QByteArray("{\"action\": \"undo\"}") << QByteArray("nothing to undo");
    QTest::newRow("redo") << QByteArray("{\"action\": \"redo\"}") << QByteArray("nothing to redo");
    QTest::newRow("other ids")
        << QByteArray("{\"action\": \"addStack\", \"objects\": {}, \"parameters\": {\"name\": "
                      "\"a\"}, \"made\": [7, 8]}")
        << QByteArray("ids do not fit");
    QTest::newRow("missing start")
        << QByteArray("{\"action\": \"start\", \"objects\": {}, \"parameters\": {\"source\": \"x.ductus\", "
                      "\"sha256\": \"\"}}")
        << QByteArray("a.jsonl:1 (x.ductus)");
    QTest::newRow("points") << QByteArray(
                                   "{\"action\": \"draw\", \"objects\": {\"layer\": 2}, \"parameters\": "
                                   "{\"strokes\": [{\"section\": \"round\", \"points\": [[0]]}]}}")
                            << QByteArray("rows of 11 numbers");
}

void ActionLogTest::refusalsNameTheLine()
{
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, words);
    const auto painting = play(text.toStdString());
    QVERIFY2(messageOf(painting).contains(words) && messageOf(painting).contains("a.jsonl:"),
             messageOf(painting).constData());
}

void ActionLogTest::startsFromAPainting()
{
    const Painting start = samplePainting(4);
    const std::vector<LogEntry> log{{"", LogStart{"x.ductus", paintingFingerprint(start)}}};
    const auto same = replayed(log, "a", [&](const std::string &) { return Result<Painting>(start); }, {});
    QVERIFY(same.ok());
    const auto other =
        replayed(log, "a", [](const std::string &) { return Result<Painting>(samplePainting(5)); }, {});
    QVERIFY(messageOf(other).contains("has changed since"));
}

void ActionLogTest::stopsStepByStep()
{
    const auto log =
        parsed("{\"action\": \"addStack\", \"objects\": {}, \"parameters\": {\"name\": \"a\"}}\n"
               "{\"action\": \"addStack\", \"objects\": {}, \"parameters\": {\"name\": \"b\"}}\n");
    std::vector<std::size_t> stacks;
    const auto painting = replayed(*log, "a", noSource, {}, [&](std::size_t, const Painting &present) {
        stacks.push_back(present.stacks.size());
        return false;
    });
    QCOMPARE(stacks, std::vector<std::size_t>{1});
    QCOMPARE(painting->stacks.size(), std::size_t(1));
}

void ActionLogTest::theManualHasAnExampleOfEveryAction()
{
    QFile manual(DUCTUS_SOURCE_DIR "/resources/manual/layerpainter-actions.md");
    QVERIFY(manual.open(QIODevice::ReadOnly));
    std::set<std::string_view> seen;
    for (const QByteArray &line : manual.readAll().split('\n')) {
        if (!line.startsWith("{\""))
            continue;
        const auto log = parsed(line.toStdString());
        QVERIFY2(log.ok() && log->size() == 1, log.ok() ? "" : log.error().message().c_str());
        if (const auto *action = std::get_if<PaintingAction>(&log->front().event))
            seen.insert(actionWord(*action));
    }
    QCOMPARE(seen.size(), std::variant_size_v<PaintingAction>);
}

QTEST_APPLESS_MAIN(ActionLogTest)
#include "action_log_test.moc"
