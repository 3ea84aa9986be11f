// The cache of an analysis as a user meets it on the command line: used, deleted, damaged, packed, not there.
#include "doodlestudio/cli/analyse_command.h"
#include "doodlestudio/cli/track_command.h"
#include "formats/png_file.h"
#include "support/clip_scenes.h"

#include <QCoreApplication>
#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

#include <filesystem>
#include <fstream>

using namespace ductus;
namespace fs = std::filesystem;

namespace {

constexpr int frames = 8;

std::string bytesOf(const fs::path &path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

class AnalysisCacheStoryTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase()
    {
        const ClipScene scene = passingScene(160, 96, frames);
        QDir().mkpath(mFolder.filePath("clip"));
        for (int t = 0; t < frames; ++t)
            QVERIFY(writePng(renderedImage(scene, t), at("clip") / (std::to_string(t) + ".png")).ok());
        std::ofstream(at("q.json"))
            << R"({"tracks": [{"id": "a", "keyframes": [{"frame": 2, "x": 60, "y": 50}]}]})";
        useCache("cache");
        QCOMPARE(analyse("p.ductus"), ExitCode::Done);
        QCOMPARE(track("p.ductus", "first.json"), ExitCode::Done);
        mTrack = bytesOf(at("first.json"));
        QVERIFY(mTrack.size() > 100);
    }
    void init() { useCache("cache"); }

    void theProjectIsSmallAndTheCacheHasTheRest()
    {
        QVERIFY(fs::file_size(at("p.ductus")) < 20'000);
        int records = 0;
        for (const auto &file : fs::recursive_directory_iterator(at("cache")))
            records += file.path().extension() == ".rec";
        QCOMPARE(records, 2 * frames + 1); // motion, depth, cameras
    }
    void anotherAnalysisGivesTheSameProject()
    {
        QCOMPARE(analyse("again.ductus"), ExitCode::Done);
        QVERIFY(bytesOf(at("again.ductus")) == bytesOf(at("p.ductus")));
    }
    void aDeletedCacheIsFilledAgain()
    {
        fs::remove_all(at("cache"));
        QCOMPARE(track("p.ductus", "second.json"), ExitCode::Done);
        QVERIFY(bytesOf(at("second.json")) == mTrack);
    }
    void damagedPiecesAreMadeAgain()
    {
        for (const auto &file : fs::recursive_directory_iterator(at("cache")))
            if (file.path().filename() == "000003.rec")
                fs::resize_file(file.path(), 100);
        QCOMPARE(track("p.ductus", "third.json"), ExitCode::Done);
        QVERIFY(bytesOf(at("third.json")) == mTrack);
    }
    void withoutCacheAndClipTheClipIsAskedFor()
    {
        fs::rename(at("clip"), at("moved"));
        useCache("empty");
        QCOMPARE(track("p.ductus", "none.json"), ExitCode::Failed);
        QVERIFY(!fs::exists(at("none.json")));
        QCOMPARE(track("p.ductus", "found.json", {"--clip", mFolder.filePath("moved")}), ExitCode::Done);
        QVERIFY(bytesOf(at("found.json")) == mTrack);
        fs::rename(at("moved"), at("clip"));
    }
    void packedProjectsNeedNeither()
    {
        QCOMPARE(analyse("packed.ductus", {"--pack"}), ExitCode::Done);
        useCache("empty");
        fs::rename(at("clip"), at("moved"));
        QCOMPARE(track("packed.ductus", "packed.json"), ExitCode::Done);
        fs::rename(at("moved"), at("clip"));
        QVERIFY(bytesOf(at("packed.json")) == mTrack);
    }
    void aCacheThatCannotBeUsedStopsNobody()
    {
        std::ofstream(at("blocked")) << "a file where the folder should be";
        useCache("blocked");
        QCOMPARE(analyse("blocked.ductus"), ExitCode::Done);
        QCOMPARE(track("blocked.ductus", "blocked.json"), ExitCode::Done);
        QVERIFY(bytesOf(at("blocked.json")) == mTrack);
    }
    void whatIsGivenIsCheckedFirst()
    {
        QCOMPARE(analyse("no.ductus", {"--depth", mFolder.filePath("clip")}), ExitCode::Failed); // colours
        QCOMPARE(analyse("no.ductus", {"--cameras", mFolder.filePath("q.json")}), ExitCode::Failed);
        QCOMPARE(analyse("no.ductus", {"--model", "depth.onnx"}), ExitCode::Failed);
        QVERIFY(!fs::exists(at("no.ductus")));
    }

private:
    fs::path at(const char *name) const { return mFolder.filePath(name).toStdString(); }
    void useCache(const char *name) { qputenv("XDG_CACHE_HOME", mFolder.filePath(name).toUtf8()); }
    ExitCode analyse(const char *project, const QStringList &more = {}) const
    {
        return runAnalyseCommand(
            QStringList{mFolder.filePath("clip"), "-q", "-o", mFolder.filePath(project)} + more);
    }
    ExitCode track(const char *project, const char *output, const QStringList &more = {}) const
    {
        return runTrackCommand(QStringList{mFolder.filePath(project), "-q", "--queries",
                                           mFolder.filePath("q.json"), "-o", mFolder.filePath(output)} +
                               more);
    }

    QTemporaryDir mFolder;
    std::string mTrack;
};

QTEST_GUILESS_MAIN(AnalysisCacheStoryTest)
#include "analysis_cache_story_test.moc"
