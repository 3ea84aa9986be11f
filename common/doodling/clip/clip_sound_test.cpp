// The sound of clips made by ffmpeg: rate, length, loudness where it was put.
#include "doodling/clip/clip_sound.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

using namespace ductus;

class ClipSoundTest : public QObject
{
    Q_OBJECT
private slots:
    void aToneIsHeardWhereItIs();
    void surroundBecomesTwoChannels();
    void silentClipsAndFoldersAreEmpty();
    void whatIsNoClipIsRefused();

private:
    QString make(const QStringList &arguments, const QString &name)
    {
        const QString path = mFolder.filePath(name);
        QProcess ffmpeg;
        ffmpeg.start("ffmpeg", QStringList{"-y", "-v", "error"} + arguments + QStringList{path});
        if (!ffmpeg.waitForFinished(60'000) || ffmpeg.exitCode() != 0)
            qFatal("ffmpeg failed: %s", ffmpeg.readAllStandardError().constData());
        return path;
    }
    QTemporaryDir mFolder;
};

void ClipSoundTest::aToneIsHeardWhereItIs()
{
    // Silence for a second, then a tone of half the loudness for a second.
    const QString path = make({"-f", "lavfi", "-i", "testsrc=size=64x48:rate=10:duration=2", "-f", "lavfi",
                               "-i", "aevalsrc=0.5*sin(880*PI*t)*gte(t\\,1):s=44100:d=2", "-c:a", "aac"},
                              "tone.mp4");
    const Result<ClipSound> sound = readSound(path.toStdString(), {}, {});
    QVERIFY2(sound.ok(), sound ? "" : sound.error().message().c_str());
    QCOMPARE(sound->sampleRate, 44100);
    QCOMPARE(sound->channels, 1);
    QVERIFY(std::abs(sound->durationSeconds() - 2.0) < 0.1);
    QVERIFY(sound->peak(0.1, 0.9) < 0.02);
    QVERIFY(std::abs(sound->peak(1.2, 1.8) - 0.5) < 0.05);
    QCOMPARE(sound->peak(5.0, 6.0), 0.0);
}

void ClipSoundTest::surroundBecomesTwoChannels()
{
    const QString path = make({"-f", "lavfi", "-i", "testsrc=size=64x48:rate=10:duration=1", "-f", "lavfi",
                               "-i", "aevalsrc=0.4|0.4|0.4|0.4|0.4|0.4:s=48000:d=1", "-c:a", "pcm_s16le"},
                              "surround.mkv");
    const Result<ClipSound> sound = readSound(path.toStdString(), {}, {});
    QVERIFY(sound.ok());
    QCOMPARE(sound->channels, 2);
    QVERIFY(std::abs(sound->durationSeconds() - 1.0) < 0.02);
    QVERIFY(std::abs(sound->peak(0.2, 0.8) - 0.4) < 0.01);
    SoundOptions half;
    half.longestSeconds = 0.5;
    const Result<ClipSound> cut = readSound(path.toStdString(), half, {});
    QVERIFY(cut.ok());
    QVERIFY(cut->durationSeconds() < 0.8);
}

void ClipSoundTest::silentClipsAndFoldersAreEmpty()
{
    const QString path = make({"-f", "lavfi", "-i", "testsrc=size=64x48:rate=10:duration=1"}, "silent.mp4");
    const Result<ClipSound> silent = readSound(path.toStdString(), {}, {});
    QVERIFY(silent.ok());
    QVERIFY(silent->isEmpty());
    const Result<ClipSound> folder = readSound(mFolder.path().toStdString(), {}, {});
    QVERIFY(folder.ok());
    QVERIFY(folder->isEmpty());
}

void ClipSoundTest::whatIsNoClipIsRefused()
{
    QFile text(mFolder.filePath("text.mp4"));
    QVERIFY(text.open(QIODevice::WriteOnly));
    text.write("not a film");
    text.close();
    QVERIFY(!readSound(text.fileName().toStdString(), {}, {}).ok());
    QVERIFY(!readSound(mFolder.filePath("none.mp4").toStdString(), {}, {}).ok());
}

QTEST_GUILESS_MAIN(ClipSoundTest)
#include "clip_sound_test.moc"
