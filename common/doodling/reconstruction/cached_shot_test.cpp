// An analysis that was stopped, lost or damaged and is done again.
#include "doodling/reconstruction/shot.h"

#include "doodling/storage/doodle_content.h"
#include "project/project_reader.h"
#include "project/project_writer.h"
#include "support/clip_scenes.h"

#include <QTemporaryDir>
#include <QtTest>

#include <fstream>

using namespace ductus;
namespace fs = std::filesystem;

namespace {

constexpr int frames = 12;
const std::string digest(64, 'a');

bool isSame(const CompactFlow &a, const CompactFlow &b)
{
    return a.width == b.width && a.height == b.height && a.motions == b.motions &&
           a.confidences == b.confidences;
}

// To the last bit.
bool isSame(const Shot &a, const Shot &b)
{
    bool same = a.frameCount() == b.frameCount() && a.knowledge == b.knowledge && a.width == b.width &&
                a.nearestDisparity == b.nearestDisparity && a.forward.size() == b.forward.size() &&
                a.longFlows.size() == b.longFlows.size() && a.depths.size() == b.depths.size();
    for (std::size_t t = 0; same && t < a.cameras.size(); ++t)
        same = a.cameras[t].worldFromCamera.matrix() == b.cameras[t].worldFromCamera.matrix() &&
               a.cameras[t].focal == b.cameras[t].focal &&
               a.pictures[t].lightness == b.pictures[t].lightness &&
               a.depths[t].disparities == b.depths[t].disparities &&
               a.depths[t].objects == b.depths[t].objects &&
               a.depths[t].mostDisparity == b.depths[t].mostDisparity;
    for (std::size_t t = 0; same && t < a.forward.size(); ++t)
        same = isSame(a.forward[t], b.forward[t]) && isSame(a.backward[t], b.backward[t]);
    for (auto i = a.longFlows.begin(), j = b.longFlows.begin(); same && i != a.longFlows.end(); ++i, ++j)
        same = i->first == j->first && isSame(i->second.forward, j->second.forward) &&
               isSame(i->second.backward, j->second.backward);
    return same;
}

} // namespace

class CachedShotTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { mWhole = std::make_unique<Shot>(*made({}, nullptr)); }
    void init() { mFolder = std::make_unique<QTemporaryDir>(); }

    void theSecondTimeItIsThere()
    {
        AnalysisReport report;
        const Result<Shot> first = made(cache(), &report);
        QVERIFY(first.ok() && first->isCached());
        QCOMPARE(report.motionsMade, frames);
        QVERIFY(isSame(*first, *mWhole));
        const Result<Shot> second = made(cache(), &report);
        QVERIFY(second.ok());
        QCOMPARE(report.motionsMade + report.depthsMade + report.damaged, 0);
        QVERIFY(isSame(*second, *mWhole));
    }
    void itGoesOnWhereItWasStopped_data()
    {
        QTest::addColumn<double>("when");
        for (double when : {0.01, 0.6, 0.83, 0.95})
            QTest::addRow("at %g", when) << when;
    }
    void itGoesOnWhereItWasStopped()
    {
        QFETCH(double, when);
        std::atomic<bool> cancelled = false;
        const JobControl stopping(&cancelled, [&](double share, std::string_view) {
            if (share > when)
                cancelled = true;
        });
        AnalysisReport stopped, report;
        const Result<Shot> first = made(cache(), &stopped, nullptr, stopping);
        QVERIFY(!first.ok() && first.error().isCancelled());
        const Result<Shot> second = made(cache(), &report);
        QVERIFY(second.ok());
        QCOMPARE(stopped.motionsMade + report.motionsMade, frames); // nothing was done twice
        QVERIFY(isSame(*second, *mWhole));
    }
    void damagedAndMissingPiecesAreMadeAgain()
    {
        AnalysisReport report;
        QVERIFY(made(cache(), &report).ok());
        const std::vector<fs::path> files = records();
        QVERIFY(int(files.size()) >= 2 * frames);
        std::ofstream(files[3], std::ios::binary | std::ios::trunc) << "no record";
        fs::remove(files[5]);
        const Result<Shot> again = made(cache(), &report);
        QVERIFY(again.ok());
        QCOMPARE(report.damaged, 1);
        QVERIFY(isSame(*again, *mWhole));
    }
    void aProjectFindsItsAnalysisAgain()
    {
        const Result<Shot> first = made(cache(), nullptr);
        QVERIFY(first.ok());
        const Shot left = throughProject(*first, false);
        QVERIFY(left.isLeftInCache && !left.isAnalysed());
        const std::optional<Shot> back = shotFromCache(options(cache(), nullptr, &left), {});
        QVERIFY(back && isSame(*back, *mWhole));
        // Deleted: the same is found again with the project's cameras.
        fs::remove_all(cache().root);
        QVERIFY(!shotFromCache(options(cache(), nullptr, &left), {}));
        const Result<Shot> redone = made(cache(), nullptr, &left);
        QVERIFY(redone.ok() && isSame(*redone, *mWhole));
    }
    void aPackedProjectNeedsNoCache()
    {
        const Result<Shot> first = made(cache(), nullptr);
        QVERIFY(first.ok());
        const Shot packed = throughProject(*first, true);
        fs::remove_all(cache().root);
        QVERIFY(packed.isAnalysed() && !packed.isLeftInCache);
        QVERIFY(isSame(packed, *mWhole));
    }

private:
    AnalysisCache cache() const { return {fs::path(mFolder->path().toStdString()) / "clips"}; }

    static ShotOptions options(AnalysisCache cache, AnalysisReport *report, const Shot *known)
    {
        ShotOptions options;
        options.cache = std::move(cache);
        options.clipDigest = digest;
        options.known = known;
        options.report = report;
        return options;
    }
    Result<Shot> made(AnalysisCache cache, AnalysisReport *report, const Shot *known = nullptr,
                      const JobControl &control = {}) const
    {
        if (report)
            *report = {};
        return reconstructShot(*clipOf(passingScene(192, 108, frames)),
                               options(std::move(cache), report, known), control);
    }
    std::vector<fs::path> records() const
    {
        std::vector<fs::path> files;
        for (const auto &file : fs::recursive_directory_iterator(cache().root))
            if (file.path().extension() == ".rec")
                files.push_back(file.path());
        std::sort(files.begin(), files.end());
        return files;
    }
    static Shot throughProject(const Shot &shot, bool packs)
    {
        Random random(1);
        Project project;
        project.id = Uuid::from(random);
        const ClipReference clip{"a.mp4", frames, shot.clipWidth, shot.clipHeight, 24.0, digest};
        project.documents.push_back(
            newDocument(Uuid::from(random), "clip",
                        std::make_shared<const DoodleContent>(clip, std::make_shared<const Shot>(shot),
                                                              UnknownMembers(), nullptr, packs)));
        const auto bytes = serializedProject(project);
        ProjectReadOptions readOptions;
        readOptions.kinds = {doodleKind()};
        const auto back = parseProject(bytes->bytes, "a.ductus", readOptions);
        return *(*doodleOf(*back))->shot();
    }

    std::unique_ptr<QTemporaryDir> mFolder;
    std::unique_ptr<Shot> mWhole;
};

QTEST_APPLESS_MAIN(CachedShotTest)
#include "cached_shot_test.moc"
