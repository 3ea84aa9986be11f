// "The computer crashed while I worked": each app's document, edited, saved and autosaved without a pause, is
// killed at moments drawn from a seed. What was saved is there, of unsaved work at most what came after the
// last autosave is lost, and the project opens, every time. Times are a thousandth of the apps': two minutes
// are 120 ms.
#include "base/random.h"
#include "document/document_files.h"
#include "document/recovery/recovery_list.h"
#include "project/saving/project_save.h"
#include "recovery/edited_document.h"

#include <QElapsedTimer>
#include <QProcess>
#include <QTemporaryDir>
#include <QThread>
#include <QtTest>

#include <algorithm>

using namespace ductus;

namespace {

constexpr int autosaveMs = 120;

int killsOfEach()
{
    bool isNumber = false;
    const int wanted = qEnvironmentVariableIntValue("DUCTUS_KILLS", &isNumber);
    return isNumber && wanted > 0 ? wanted : 6;
}

/// What a killed program had told; -1: nothing of the kind.
struct Told
{
    int edited = -1, saved = -1, autosaved = -1;
    int saves = 0, autosaves = 0;
};

Told toldIn(const QByteArray &output)
{
    Told told;
    for (const QByteArray &line : output.split('\n')) {
        const int space = int(line.indexOf(' '));
        const int count = line.mid(space + 1).toInt();
        if (line.startsWith("edited "))
            told.edited = count;
        if (line.startsWith("saved "))
            told.saved = count, ++told.saves;
        if (line.startsWith("autosaved "))
            told.autosaved = count, ++told.autosaves;
    }
    return told;
}

int temporariesIn(const QString &folder)
{
    return int(QDir(folder)
                   .entryList({QStringLiteral("*.tmp"), QStringLiteral(".*.tmp")}, QDir::Files | QDir::Hidden)
                   .size());
}

double share(std::vector<int> values, double part)
{
    std::sort(values.begin(), values.end());
    return values.empty() ? 0.0 : values[std::size_t(part * double(values.size() - 1))];
}

} // namespace

class KillJourneyTest : public QObject
{
    Q_OBJECT
private slots:
    void nothingSavedIsLost_data();
    void nothingSavedIsLost();
};

void KillJourneyTest::nothingSavedIsLost_data()
{
    QTest::addColumn<QString>("kind");
    for (const QString &kind : editedKinds())
        QTest::newRow(qPrintable(kind)) << kind;
}

void KillJourneyTest::nothingSavedIsLost()
{
    QFETCH(QString, kind);
    QTemporaryDir folder;
    QVERIFY(folder.isValid());
    QCoreApplication::setApplicationName(kind);
    Random random(20261122 + std::uint64_t(kind.size()));
    const int kills = killsOfEach();
    int temporaries = 0, withCopy = 0, copyWasAhead = 0, saves = 0, autosaves = 0;
    std::vector<int> lostEdits, lostMilliseconds;
    QString path, state;
    int recoverable = 0;
    for (int kill = 0; kill < kills; ++kill) {
        if (kill % 8 == 0) { // a new project; in between work goes on with what the kill left
            path = folder.filePath(QStringLiteral("%1/work.ductus").arg(kill));
            state = folder.filePath(QStringLiteral("%1/state").arg(kill));
            QVERIFY(QDir().mkpath(QFileInfo(path).path()));
            recoverable = 0;
        }
        QProcess program;
        program.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        program.start(
            QStringLiteral(DUCTUS_EDIT_LOOP),
            {kind, path, state, QString::number(random.index(1 << 30)), QString::number(autosaveMs)});
        QVERIFY(program.waitForStarted());
        QByteArray output;
        while (!output.contains('\n')) { // it has opened what there was
            QVERIFY2(program.waitForReadyRead(60000), "the program does not begin");
            output += program.readAllStandardOutput();
        }
        const int begun = toldIn(output).edited;
        QVERIFY2(begun >= recoverable,
                 qPrintable(QString("it began with %1 edits of %2").arg(begun).arg(recoverable)));
        // When each edit became known, to tell how old what is lost was.
        QElapsedTimer clock;
        clock.start();
        std::vector<std::pair<qint64, int>> seen{{0, begun}};
        // After so many things it told, and a moment more: a moment of its work, however busy the machine is.
        const int things = 1 + int(random.index(160));
        int lines = 1;
        while (lines < things && program.waitForReadyRead(60000)) {
            output += program.readAllStandardOutput();
            lines = int(output.count('\n'));
            seen.emplace_back(clock.elapsed(), toldIn(output.right(4096)).edited);
        }
        QThread::usleep(random.index(20000));
        QVERIFY2(program.state() == QProcess::Running, "the program ended by itself");
        const qint64 killedAt = clock.elapsed();
        program.kill(); // SIGKILL
        QVERIFY(program.waitForFinished(60000));
        QCOMPARE(program.exitStatus(), QProcess::CrashExit);
        output += program.readAllStandardOutput();
        const Told told = toldIn(output.left(output.lastIndexOf('\n') + 1));
        saves += told.saves;
        autosaves += told.autosaves;

        // After the restart.
        int inFile = -1;
        if (QFileInfo::exists(path)) {
            const Result<int> edits = editsIn(kind, path);
            QVERIFY2(edits.ok(), edits ? "" : edits.error().message().c_str());
            inFile = *edits;
            QVERIFY2(inFile >= 0, "the file holds something that was never drawn");
            const Result<OpenedProject> opened = openProjectFile(path, kind);
            QVERIFY(opened.ok());
            QVERIFY2(opened->readOnlyReason.isEmpty(),
                     qPrintable(opened->readOnlyReason)); // the dead hold no lock
        }
        QVERIFY2(
            inFile >= told.saved,
            qPrintable(
                QString("kill %1: %2 edits were saved, %3 are there").arg(kill).arg(told.saved).arg(inFile)));
        int inCopy = -1;
        const QList<RecoveredFile> copies = recoveredFiles(state);
        QVERIFY(copies.size() <= 3); // they do not pile up
        for (const RecoveredFile &copy : copies) {
            const Result<int> edits = editsIn(kind, copy.copy);
            QVERIFY2(edits.ok(), edits ? "" : edits.error().message().c_str());
            QVERIFY2(*edits >= 0, "the copy holds something that was never drawn");
            inCopy = std::max(inCopy, *edits);
            QVERIFY(copy.originalPath.isEmpty() || copy.originalPath == path);
        }
        recoverable = std::max(inFile, inCopy);
        QVERIFY2(recoverable >= std::max(told.saved, told.autosaved),
                 qPrintable(QString("kill %1: %2 edits were autosaved, %3 saved, %4 can be had")
                                .arg(kill)
                                .arg(told.autosaved)
                                .arg(told.saved)
                                .arg(recoverable)));
        withCopy += inCopy >= 0;
        copyWasAhead += inCopy > inFile;
        temporaries += temporariesIn(QFileInfo(path).path()) + temporariesIn(state);
        lostEdits.push_back(std::max(0, told.edited - std::max(recoverable, begun)));
        // The first edit that is gone was seen at the earliest then.
        const auto gone = std::find_if(seen.begin(), seen.end(),
                                       [&](const auto &moment) { return moment.second > recoverable; });
        lostMilliseconds.push_back(gone == seen.end() ? 0 : int(killedAt - gone->first));
        recoverable = std::max(recoverable, 0);
    }
    qInfo("%s: %d kills between %d saves and %d autosaves; a copy after %d, ahead of the file after %d; %d "
          "files left half "
          "written; lost at most %d edits and %d ms of work, in the middle %d ms",
          qPrintable(kind), kills, saves, autosaves, withCopy, copyWasAhead, temporaries,
          int(share(lostEdits, 1.0)), int(share(lostMilliseconds, 1.0)), int(share(lostMilliseconds, 0.5)));
    // Else the kills met nothing, and the above proves nothing.
    QVERIFY(saves + autosaves >= kills);
    QVERIFY(share(lostEdits, 1.0) > 0);
    if (kills >= 50) {
        QVERIFY2(copyWasAhead >= kills / 10, "autosave was hardly ever needed");
        QVERIFY2(share(lostMilliseconds, 0.9) < 4 * autosaveMs,
                 "more than about the last autosave's time was lost");
    }
}

int main(int argc, char **argv)
{
    // 200 kills on a busy machine take longer than Qt Test's five minutes.
    qputenv("QTEST_FUNCTION_TIMEOUT", "1800000"); // ms
    QCoreApplication app(argc, argv);
    KillJourneyTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "kill_journey_test.moc"
