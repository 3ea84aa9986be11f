#include "support/clip_scenes.h"

#include <QtTest>

using namespace ductus;

namespace {

constexpr int width = 160, height = 90, frames = 13;

double grey(const Image &image, double x, double y)
{
    const auto at = [&](int cx, int cy) {
        const Rgba c = image.at(std::clamp(cx, 0, width - 1), std::clamp(cy, 0, height - 1));
        return (c[0] + c[1] + c[2]) / 3.0;
    };
    const int i = int(std::floor(x - 0.5)), j = int(std::floor(y - 0.5));
    const double u = x - 0.5 - i, v = y - 0.5 - j;
    return (at(i, j) * (1 - u) + at(i + 1, j) * u) * (1 - v) +
           (at(i, j + 1) * (1 - u) + at(i + 1, j + 1) * u) * v;
}

} // namespace

class ClipScenesTest : public QObject
{
    Q_OBJECT
private slots:
    void motionLeadsToTheSameColours_data()
    {
        QTest::addColumn<int>("scene");
        for (int i = 0; i < int(allClipScenes(width, height, frames).size()); ++i)
            QTest::newRow(allClipScenes(width, height, frames)[std::size_t(i)].name.c_str()) << i;
    }
    void motionLeadsToTheSameColours()
    {
        QFETCH(int, scene);
        const ClipScene clip = allClipScenes(width, height, frames)[std::size_t(scene)];
        const ClipTruth here = renderedFrame(clip, 5), there = renderedFrame(clip, 6);
        double moved = 0.0, still = 0.0;
        int seen = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const std::size_t i = std::size_t(y * width + x);
                if (!here.isSeenNext[i])
                    continue;
                const double own = grey(here.image, x + 0.5, y + 0.5);
                moved += std::abs(
                    own - grey(there.image, x + 0.5 + here.motions[i].x(), y + 0.5 + here.motions[i].y()));
                still += std::abs(own - grey(there.image, x + 0.5, y + 0.5));
                ++seen;
            }
        QVERIFY(seen > width * height / 2);
        QVERIFY2(moved / seen < 5.0, qPrintable(QString::number(moved / seen)));
        QVERIFY(moved < 0.7 * still || clip.name == "tripod");
    }
    void depthIsWhereTracksAre()
    {
        const ClipScene clip = passingScene(width, height, frames);
        const ClipTruth truth = renderedFrame(clip, 4);
        for (int y = 3; y < height; y += 17)
            for (int x = 5; x < width; x += 19) {
                const ClipTrack track = trackOf(clip, 4, {x + 0.5, y + 0.5});
                const std::size_t i = std::size_t(y * width + x);
                QCOMPARE(int(track.pixels.size()), frames);
                QVERIFY(std::abs(track.depths[4] - double(truth.depths[i])) < 1e-4);
                QVERIFY((track.pixels[4] - Vec2(x + 0.5, y + 0.5)).norm() < 1e-6);
                QVERIFY(track.isVisible[4]);
                QVERIFY((track.pixels[5] - track.pixels[4] - truth.motions[i].cast<double>()).norm() < 1e-3);
                QCOMPARE(bool(track.isVisible[5]), bool(truth.isSeenNext[i]));
            }
    }
    void aBoxIsHiddenByThePost()
    {
        const ClipScene clip = passingScene(width, height, frames);
        const ClipTruth first = renderedFrame(clip, 0);
        const int box = int(clip.bodies.size()) - 1;
        Vec2 middle = Vec2::Zero();
        int count = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                if (first.bodies[std::size_t(y * width + x)] == box) {
                    middle += Vec2(x + 0.5, y + 0.5);
                    ++count;
                }
        QVERIFY(count > 50);
        const ClipTrack track = trackOf(clip, 0, middle / count);
        const long hidden = std::count(track.isVisible.begin(), track.isVisible.end(), false);
        QVERIFY(track.isVisible.front() && track.isVisible.back());
        QVERIFY(hidden >= 1 && hidden < frames / 2);
    }
    void theTrueShotKnowsAll()
    {
        const ClipScene clip = tripodScene(width, height, 3);
        const Shot shot = trueShot(clip);
        QCOMPARE(shot.frameCount(), 3);
        const ClipTruth truth = renderedFrame(clip, 1);
        const std::size_t i = std::size_t(46 * width + 82);
        QVERIFY(std::abs(shot.depthAt(1, {82.5, 46.5}) / double(truth.depths[i]) - 1.0) < 0.05);
        bool moves = false;
        for (int x = 0; x < width; ++x)
            moves = moves || shot.objectAt(1, {x + 0.5, 60.0}) > 0;
        QVERIFY(moves);
    }
    void clipsRenderWhatIsAskedFor()
    {
        const ClipScene scene = panScene(width, height, frames);
        const std::unique_ptr<Clip> clip = clipOf(scene);
        QCOMPARE(clip->info().frameCount, frames);
        const Result<Image> frame = clip->frame(7);
        QVERIFY(frame.ok());
        QVERIFY(frame->pixels == renderedImage(scene, 7).pixels);
    }
};

QTEST_APPLESS_MAIN(ClipScenesTest)
#include "clip_scenes_test.moc"
