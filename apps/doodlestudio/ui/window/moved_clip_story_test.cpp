// "I moved my film into another folder": the project opens with it, and says so; another film that only has
// its size is told from it.
#include "document/document_files.h"
#include "doodlestudio/ui/testing/studio_under_test.h"
#include "support/clip_scenes.h"
#include "widgets/shell/message_bar.h"

using namespace ductus;

namespace {

constexpr int waitMs = 60'000;

std::vector<Image> film(int first)
{
    const ClipScene scene = tripodScene(96, 54, 12);
    std::vector<Image> frames;
    for (int t = 0; t < 6; ++t)
        frames.push_back(renderedImage(scene, first + t));
    return frames;
}

bool says(StudioUnderTest &app, const QString &words)
{
    for (const Message &message : app.window->messages()->messages())
        if (message.what.contains(words))
            return true;
    return false;
}

} // namespace

class MovedClipStoryTest : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void isFoundWhereItWasMovedTo();
    void anotherFilmIsNotTakenForIt();

private:
    std::unique_ptr<QTemporaryDir> mFolder;
    QString mClip, mProject;
};

// A project on a clip, saved.
void MovedClipStoryTest::init()
{
    mFolder = std::make_unique<QTemporaryDir>();
    mClip = mFolder->filePath("films/clip.mp4");
    mProject = mFolder->filePath("lesson.ductus");
    QDir().mkpath(mFolder->filePath("films"));
    writeClip(film(0), mClip, 12.0);
    StudioUnderTest app;
    QVERIFY(QTest::qWaitForWindowExposed(app.window.get()));
    QVERIFY(app.open(mClip));
    QVERIFY(QTest::qWaitFor([&] { return app.window->doodle().shot() != nullptr; }, waitMs));
    QVERIFY(!app.window->doodle().clip().digest.empty());
    app.window->doodle().setSnapshotFolder(mFolder->path());
    bool isSaved = false;
    saveDocument(app.window->doodle(), app.jobs, mProject,
                 [&](Result<SaveReport> report) { isSaved = report.ok(); });
    QVERIFY(app.jobs.waitForAll(waitMs));
    QVERIFY(isSaved);
}

void MovedClipStoryTest::isFoundWhereItWasMovedTo()
{
    const QString moved = mFolder->filePath("school/first lesson.mp4");
    QDir().mkpath(mFolder->filePath("school"));
    QVERIFY(QFile::rename(mClip, moved));
    StudioUnderTest app;
    QVERIFY(QTest::qWaitForWindowExposed(app.window.get()));
    QVERIFY(app.open(mProject));
    QCOMPARE(app.window->doodle().clipPath(), moved);
    QVERIFY(app.window->doodle().isModified()); // so that its place is asked for once
    QVERIFY(says(app, moved));
    QVERIFY(!says(app, "is not where it was"));
    app.shot("moved-clip");
    QVERIFY(app.jobs.waitForAll(waitMs));
}

void MovedClipStoryTest::anotherFilmIsNotTakenForIt()
{
    QVERIFY(QFile::remove(mClip));
    writeClip(film(6), mFolder->filePath("films/other.mp4"), 12.0); // as long, as large
    StudioUnderTest app;
    QVERIFY(QTest::qWaitForWindowExposed(app.window.get()));
    app.drop(mProject);
    QVERIFY(QTest::qWaitFor([&] { return says(app, "is not where it was"); }, waitMs));
    QCOMPARE(app.window->doodle().clipPath(), mClip);
    app.shot("lost-clip");
    QVERIFY(app.jobs.waitForAll(waitMs));
}

int main(int argc, char *argv[])
{
    QStandardPaths::setTestModeEnabled(true);
    QLocale::setDefault(QLocale::c());
    QApplication application(argc, argv);
    MovedClipStoryTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "moved_clip_story_test.moc"
