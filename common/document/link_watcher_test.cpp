// What other programs write is noticed: into the file, by renaming another into its place, and anew.
#include "document/link_watcher.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

using namespace ductus;

namespace {

void write(const QString &path, const QByteArray &text)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
        qFatal("cannot write %s", qPrintable(path));
}

void replace(const QString &path, const QByteArray &text)
{
    write(path + ".part", text);
    QFile::remove(path);
    if (!QFile::rename(path + ".part", path))
        qFatal("cannot rename to %s", qPrintable(path));
}

} // namespace

class LinkWatcherTest : public QObject
{
    Q_OBJECT
private slots:
    void tellsOfEverySave();
    void tellsOfAFileThatComes();
    void isSilentAboutOtherFiles();
};

void LinkWatcherTest::tellsOfEverySave()
{
    QTemporaryDir folder;
    const QString path = folder.filePath("a.ductus");
    write(path, "1");
    LinkWatcher watcher;
    watcher.setFiles({path});
    QSignalSpy spy(&watcher, &LinkWatcher::worthALook);
    write(path, "12");
    QTRY_COMPARE_WITH_TIMEOUT(spy.count(), 1, 20'000);
    // A rename takes the watched file away; the one in its place is watched as well, again and again.
    for (int i = 2; i < 5; ++i) {
        replace(path, QByteArray(1 + i, 'x'));
        QTRY_COMPARE_WITH_TIMEOUT(spy.count(), i, 20'000);
    }
}

void LinkWatcherTest::tellsOfAFileThatComes()
{
    QTemporaryDir folder;
    const QString path = folder.filePath("later.ductus");
    LinkWatcher watcher;
    watcher.setFiles({path});
    QSignalSpy spy(&watcher, &LinkWatcher::worthALook);
    write(path, "1");
    QTRY_COMPARE_WITH_TIMEOUT(spy.count(), 1, 20'000);
}

void LinkWatcherTest::isSilentAboutOtherFiles()
{
    QTemporaryDir folder;
    const QString path = folder.filePath("a.ductus"), last = folder.filePath("b.ductus");
    write(path, "1");
    LinkWatcher watcher, control;
    watcher.setFiles({path});
    control.setFiles({last});
    QSignalSpy spy(&watcher, &LinkWatcher::worthALook), noticed(&control, &LinkWatcher::worthALook);
    write(last, "other");
    QTRY_COMPARE_WITH_TIMEOUT(noticed.count(), 1, 20'000);
    QCOMPARE(spy.count(), 0);
}

QTEST_GUILESS_MAIN(LinkWatcherTest)
#include "link_watcher_test.moc"
