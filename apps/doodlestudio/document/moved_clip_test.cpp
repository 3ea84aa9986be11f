// "I tidied up my films": a clip is found by its bytes, under another name in another folder.
#include "doodlestudio/document/moved_clip.h"

#include "document/document_files.h"
#include "doodling/clip/clip_digest.h"

#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

using namespace ductus;

namespace {

void write(const QString &path, const QByteArray &bytes)
{
    QDir().mkpath(QFileInfo(path).path());
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
}

ClipReference knownBy(const QString &path)
{
    ClipReference known{path.toStdString(), 12, 96, 54, 25.0};
    known.digest = clipDigest(enginePath(path), {}).value();
    return known;
}

} // namespace

class MovedClipTest : public QObject
{
    Q_OBJECT
private slots:
    void isFoundByItsBytes_data();
    void isFoundByItsBytes();
    void oneOfItsNameIsNotEnough();
    void likenessIsToldByFactsThenBytes();
};

void MovedClipTest::isFoundByItsBytes_data()
{
    QTest::addColumn<QString>("now");
    QTest::newRow("beside, renamed") << "films/renamed.mp4";
    QTest::newRow("one folder down") << "films/school/clip.mp4";
    QTest::newRow("beside the project") << "lessons/übung.MP4";
}

void MovedClipTest::isFoundByItsBytes()
{
    QFETCH(QString, now);
    QTemporaryDir folder;
    const QString clip = folder.filePath("films/clip.mp4"), moved = folder.filePath(now);
    write(clip, "the film itself");
    write(folder.filePath("films/other.mp4"), "another film");
    write(folder.filePath("lessons/clip.mp4"), "another film of the same name");
    const ClipReference known = knownBy(clip);
    QDir().mkpath(QFileInfo(moved).path());
    QVERIFY(QFile::rename(clip, moved));
    const QStringList places = placesOfClips(clip, folder.filePath("lessons/lesson.ductus"));
    const Result<QString> found = movedClip(known, clip, places, {});
    QVERIFY2(found, found ? "" : found.error().message().c_str());
    QCOMPARE(*found, moved);
}

void MovedClipTest::oneOfItsNameIsNotEnough()
{
    QTemporaryDir folder;
    const QString clip = folder.filePath("films/clip.mp4");
    write(clip, "the film itself");
    ClipReference known = knownBy(clip);
    write(clip, "another film now");
    const QStringList places{folder.filePath("films"), folder.filePath("no such folder")};
    QVERIFY(movedClip(known, clip, places, {}).value().isEmpty());
    known.digest.clear(); // nothing to tell it by
    QVERIFY(movedClip(known, clip, places, {}).value().isEmpty());
}

void MovedClipTest::likenessIsToldByFactsThenBytes()
{
    ClipReference known{"a.mp4", 12, 96, 54, 25.0, "abc"}, found = known;
    QVERIFY(likenessOf(known, found) == ClipLikeness::Same);
    found.digest = "abd";
    QVERIFY(likenessOf(known, found) == ClipLikeness::OtherBytes);
    found.digest.clear();
    QVERIFY(likenessOf(known, found) == ClipLikeness::Alike);
    found.frameCount = 13;
    QVERIFY(likenessOf(known, found) == ClipLikeness::Other);
}

QTEST_GUILESS_MAIN(MovedClipTest)
#include "moved_clip_test.moc"
