#include "doodling/tracking/track_canvas.h"

#include <QtTest>

using namespace ductus;

namespace {

constexpr int frames = 21;
const Vec2 start(100.0, 60.0), speed(3.0, 1.0);

// Everything moves evenly to the lower right, in front of a camera that stands still.
Shot movingShot()
{
    Shot shot;
    shot.width = shot.clipWidth = 320;
    shot.height = shot.clipHeight = 160;
    shot.cameras.assign(frames, ShotCamera{Eigen::Isometry3d::Identity(), 300.0, {160.0, 80.0}});
    const FlowField still{80, 40, 4.0, std::vector<Eigen::Vector2f>(3200, {0.0f, 0.0f}),
                          std::vector<float>(3200, 1.0f)};
    FlowField ahead = still, back = still;
    ahead.motions.assign(3200, speed.cast<float>());
    back.motions.assign(3200, -speed.cast<float>());
    for (int t = 0; t < frames; ++t) {
        Image picture(320, 160);
        for (int y = 0; y < 160; ++y)
            for (int x = 0; x < 320; ++x) {
                const auto shade =
                    std::uint8_t(128 + 100 * std::sin(0.07 * (x - 3 * t)) * std::cos(0.05 * (y - t)));
                picture.set(x, y, {shade, std::uint8_t(255 - shade), 90, 255});
            }
        shot.pictures.push_back(smallPictureOf(picture));
        if (t + 1 < frames) {
            shot.forward.push_back(ahead);
            shot.backward.push_back(back);
        }
    }
    return shot;
}

CanvasKeyframes placedAt(int frame)
{
    return {{{frame, start + frame * speed, {}, false}}, {}, {}, {}};
}

// A textured disc that turns by 0.04 and grows by a hundredth a frame, before a ground that stands still.
Shot turningShot()
{
    const Vec2 middle(160.0, 80.0);
    const auto moved = [&](const Vec2 &p, int steps) -> Vec2 {
        if ((p - middle).norm() > 75.0)
            return p;
        return middle + std::pow(1.01, steps) * (Eigen::Rotation2Dd(0.04 * steps) * (p - middle));
    };
    Shot shot = movingShot();
    for (int t = 0; t < frames; ++t) {
        Image picture(320, 160);
        for (int y = 0; y < 160; ++y)
            for (int x = 0; x < 320; ++x) {
                const Vec2 p = moved({x + 0.5, y + 0.5}, -t);
                const bool isDisc = (p - middle).norm() <= 75.0;
                const auto shade = std::uint8_t(128 + 60 * std::sin(0.1 * p.x()) * std::cos(0.08 * p.y()));
                picture.set(x, y, {shade, std::uint8_t(isDisc ? 60 : 200), 90, 255});
            }
        shot.pictures[std::size_t(t)] = smallPictureOf(picture);
        if (t + 1 == frames)
            break;
        FlowField ahead{80, 40, 4.0, {}, std::vector<float>(3200, 1.0f)}, back = ahead;
        for (int cell = 0; cell < 3200; ++cell) {
            const Vec2 p(4.0 * (cell % 80) + 2.0, 4.0 * (cell / 80) + 2.0);
            ahead.motions.push_back((moved(p, 1) - p).cast<float>());
            back.motions.push_back((moved(p, -1) - p).cast<float>());
        }
        shot.forward[std::size_t(t)] = ahead;
        shot.backward[std::size_t(t)] = back;
    }
    return shot;
}

double angleBetween(const Eigen::Quaterniond &a, const Eigen::Quaterniond &b)
{
    return a.angularDistance(b);
}

} // namespace

class TrackCanvasTest : public QObject
{
    Q_OBJECT
private slots:
    void followsItsPointFacingTheCamera()
    {
        const auto track = trackCanvas(movingShot(), placedAt(4), {}, {});
        QVERIFY(track.ok());
        QCOMPARE(int(track->frames.size()), frames);
        for (int t = 0; t < frames; ++t) {
            const CanvasFrame &frame = track->frames[std::size_t(t)];
            QVERIFY((frame.pixel - start - t * speed).norm() < 0.1);
            QVERIFY(angleBetween(frame.worldFromCanvas, Eigen::Quaterniond::Identity()) < 1e-3);
            QCOMPARE(frame.scale, 1.0);
            QVERIFY(frame.isVisible);
        }
    }
    void depthIsSetWithoutMovingThePicture()
    {
        CanvasKeyframes keys = placedAt(0);
        keys.depths = {{6, 4.0}, {16, 8.0}};
        const Shot shot = movingShot();
        const auto track = trackCanvas(shot, keys, {}, {});
        QVERIFY(track.ok());
        QVERIFY(std::abs(track->frames[6].depth - 4.0) < 1e-9);
        QVERIFY(std::abs(track->frames[16].depth - 8.0) < 1e-9);
        QVERIFY(track->frames[11].depth > 5.0 && track->frames[11].depth < 6.5);
        for (int t = 0; t < frames; ++t) {
            const CanvasFrame &frame = track->frames[std::size_t(t)];
            QVERIFY((frame.pixel - start - t * speed).norm() < 0.1);
            QVERIFY((*shot.cameras[std::size_t(t)].projected(frame.position) - frame.pixel).norm() < 1e-6);
        }
    }
    void aDepthWithAPositionIsMetExactly()
    {
        CanvasKeyframes keys = placedAt(3);
        keys.positions.front().depth = 5.0;
        const auto track = trackCanvas(movingShot(), keys, {}, {});
        QVERIFY(std::abs(track->frames[3].depth - 5.0) < 1e-9);
        QVERIFY((track->frames[3].pixel - keys.positions.front().pixel).norm() < 1e-9);
    }
    void turnsAndSizesAreMetExactly_data()
    {
        QTest::addColumn<bool>("isStill");
        QTest::newRow("along the path") << false;
        QTest::newRow("still") << true;
    }
    void turnsAndSizesAreMetExactly()
    {
        QFETCH(bool, isStill);
        CanvasTrackOptions options;
        options.turning = isStill ? CanvasTurning::Still : CanvasTurning::AlongPath;
        CanvasKeyframes keys = placedAt(10);
        const Eigen::Quaterniond a(Eigen::AngleAxisd(0.4, Vec3::UnitY())),
            b(Eigen::AngleAxisd(1.2, Vec3::UnitZ()));
        keys.turns = {{2, a, false}, {18, b, false}};
        keys.scales = {{5, 1.0}, {15, 4.0}};
        const auto track = trackCanvas(movingShot(), keys, options, {});
        QVERIFY(track.ok());
        QVERIFY(angleBetween(track->frames[2].worldFromCanvas, a) < 1e-6);
        QVERIFY(angleBetween(track->frames[18].worldFromCanvas, b) < 1e-6);
        QCOMPARE(track->frames[0].scale, 1.0);
        QVERIFY(std::abs(track->frames[10].scale - 2.0) < 1e-9); // as often doubled in each half
        QVERIFY(std::abs(track->frames[20].scale - 4.0) < 1e-9);
    }
    void anInterpolatedTurnTakesTheShortestWay()
    {
        CanvasKeyframes keys = placedAt(0);
        const Eigen::Quaterniond b(Eigen::AngleAxisd(1.0, Vec3::UnitZ()));
        keys.turns = {{0, Eigen::Quaterniond::Identity(), true}, {20, b, false}};
        const auto track = trackCanvas(movingShot(), keys, {}, {});
        const Eigen::Quaterniond half(Eigen::AngleAxisd(0.5, Vec3::UnitZ()));
        QVERIFY(angleBetween(track->frames[10].worldFromCanvas, half) < 1e-9);
    }
    void turnsAndGrowsWithItsThing()
    {
        const Shot shot = turningShot();
        CanvasKeyframes keys{{{10, {165.0, 80.0}, {}, false}}, {}, {}, {}};
        CanvasTrackOptions options;
        options.turning = CanvasTurning::WithThing;
        options.followsSize = true;
        const auto track = trackCanvas(shot, keys, options, {});
        QVERIFY(track.ok());
        for (int t : {0, 10, 20}) {
            const CanvasFrame &frame = track->frames[std::size_t(t)];
            const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.04 * (t - 10), Vec3::UnitZ()));
            QVERIFY2(angleBetween(frame.worldFromCanvas, turned) < 0.08,
                     qPrintable(QString::number(angleBetween(frame.worldFromCanvas, turned))));
            QVERIFY2(std::abs(frame.scale / std::pow(1.01, t - 10) - 1.0) < 0.04,
                     qPrintable(QString::number(frame.scale)));
        }
        // Keyframes stay exact, whatever the thing does.
        const Eigen::Quaterniond a(Eigen::AngleAxisd(0.4, Vec3::UnitY())),
            b(Eigen::AngleAxisd(-1.2, Vec3::UnitZ()));
        keys.turns = {{4, a, false}, {18, b, false}};
        keys.scales = {{5, 2.0}, {15, 3.0}};
        const auto kept = trackCanvas(shot, keys, options, {});
        QVERIFY(angleBetween(kept->frames[4].worldFromCanvas, a) < 1e-6);
        QVERIFY(angleBetween(kept->frames[18].worldFromCanvas, b) < 1e-6);
        QVERIFY(std::abs(kept->frames[5].scale - 2.0) < 1e-9);
        QVERIFY(std::abs(kept->frames[15].scale - 3.0) < 1e-9);
    }
    void wrongKeyframesAreRefused()
    {
        const Shot shot = movingShot();
        CanvasKeyframes none;
        QVERIFY(!trackCanvas(shot, none, {}, {}).ok());
        CanvasKeyframes keys = placedAt(0);
        keys.depths = {{3, 0.0}};
        QVERIFY(!trackCanvas(shot, keys, {}, {}).ok());
        keys.depths = {{3, 1.0}, {3, 2.0}};
        QVERIFY(!trackCanvas(shot, keys, {}, {}).ok());
        keys.depths.clear();
        keys.scales = {{frames, 1.0}};
        QVERIFY(!trackCanvas(shot, keys, {}, {}).ok());
        keys.scales.clear();
        keys.turns = {{0, Eigen::Quaterniond(0.0, 0.0, 0.0, 0.0), false}};
        QVERIFY(!trackCanvas(shot, keys, {}, {}).ok());
    }
};

QTEST_APPLESS_MAIN(TrackCanvasTest)
#include "track_canvas_test.moc"
