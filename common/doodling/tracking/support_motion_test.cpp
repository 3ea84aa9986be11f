#include "doodling/tracking/support_motion.h"

#include "doodling/tracking/motion_between.h"

#include <QtTest>

using namespace ductus;

namespace {

constexpr int frames = 13, cells = 80;

// A disc that turns and grows about a middle that moves, before a ground that stands still.
struct Film
{
    double turn = 0.05, growth = 1.01; // a frame
    Vec2 start{150.0, 150.0}, speed{2.0, 1.0};
    double radius = 90.0;

    Vec2 middle(int t) const { return start + t * speed; }
    bool isDisc(int t, const Vec2 &p) const { return (p - middle(t)).norm() < radius * std::pow(growth, t); }
    Vec2 moved(const Vec2 &p, int from, int to) const
    {
        const Eigen::Rotation2Dd rotation((to - from) * turn);
        return middle(to) + std::pow(growth, to - from) * (rotation * (p - middle(from)));
    }
    FlowField flow(int from, int to) const
    {
        FlowField field{cells, cells, 4.0, {}, {}};
        for (int i = 0; i < cells * cells; ++i) {
            const Vec2 p(4.0 * (i % cells) + 2.0, 4.0 * (i / cells) + 2.0);
            const Vec2 motion = isDisc(from, p) ? Vec2(moved(p, from, to) - p) : Vec2(Vec2::Zero());
            field.motions.push_back(motion.cast<float>());
            field.confidences.push_back(isDisc(from, p) || !isDisc(to, p) ? 1.0f : 0.05f);
        }
        return field;
    }
    Shot shot() const
    {
        Shot shot;
        shot.width = shot.height = shot.clipWidth = shot.clipHeight = 4 * cells;
        shot.cameras.assign(frames, ShotCamera{Eigen::Isometry3d::Identity(), 300.0, {160.0, 160.0}});
        for (int t = 0; t + 1 < frames; ++t) {
            shot.forward.push_back(flow(t, t + 1));
            shot.backward.push_back(flow(t + 1, t));
        }
        for (int t = 0; t + 4 < frames; ++t)
            shot.longFlows[{t, 4}] = {compacted(flow(t, t + 4)), compacted(flow(t + 4, t))};
        return shot;
    }
};

} // namespace

class SupportMotionTest : public QObject
{
    Q_OBJECT
private slots:
    void turnAndGrowthAreMeasured_data()
    {
        QTest::addColumn<bool>("isBackward");
        QTest::newRow("ahead") << false;
        QTest::newRow("back") << true;
    }
    void turnAndGrowthAreMeasured()
    {
        QFETCH(bool, isBackward);
        const Film film;
        const Shot shot = film.shot();
        const int from = isBackward ? frames - 1 : 0, end = isBackward ? 0 : frames - 1;
        const PixelKeyframe key{from, film.middle(from) + Vec2(20.0, -10.0)};
        SupportOptions options;
        options.gaps = gapsOf(shot);
        QCOMPARE(options.gaps, (std::vector<int>{1, 4}));
        const std::vector<FollowedPixel> followed =
            followPixel(shot, key, end, {}, {options.gaps, 0.3, 0.0, 0.0});
        const SupportMotion motion = supportMotion(shot, key, end, followed, options);
        const Vec2 there = film.moved(key.pixel, from, end);
        QVERIFY((followed.back().pixel - there).norm() < 1.0);
        QVERIFY2((motion.places.back().pixel - there).norm() < 6.0,
                 qPrintable(QString::number((motion.places.back().pixel - there).norm())));
        const double turn = film.turn * (end - from), growth = std::pow(film.growth, end - from);
        QVERIFY2(std::abs(motion.turns.back() - turn) < 0.15 * std::abs(turn),
                 qPrintable(QString::number(motion.turns.back())));
        QVERIFY2(std::abs(motion.growths.back() - growth) < 0.05,
                 qPrintable(QString::number(motion.growths.back())));
    }
    void aStillGroundStays()
    {
        const Shot shot = Film().shot();
        const PixelKeyframe key{0, {290.0, 290.0}};
        const std::vector<FollowedPixel> followed =
            followPixel(shot, key, frames - 1, {}, {{1}, 0.3, 0.0, 0.0});
        const SupportMotion motion = supportMotion(shot, key, frames - 1, followed, {});
        QVERIFY((motion.places.back().pixel - key.pixel).norm() < 1.0);
        QVERIFY(std::abs(motion.turns.back()) < 0.02);
    }
};

QTEST_APPLESS_MAIN(SupportMotionTest)
#include "support_motion_test.moc"
