#include "doodling/tracking/track_point.h"

#include <QtTest>

using namespace ductus;

namespace {

constexpr int width = 320, height = 160, frames = 24;
constexpr double speed = 4.0; // pixels a frame

// A red square moves to the right over a grey ground, behind a green post that stands still. Everything is
// known exactly.
struct Film
{
    int postLeft = 1000, postRight = 1000;

    double squareLeft(int t) const { return 60.0 + speed * t; }
    bool isPost(double x) const { return x >= postLeft && x < postRight; }
    bool isSquare(int t, double x, double y) const
    {
        return !isPost(x) && x >= squareLeft(t) && x < squareLeft(t) + 40.0 && y >= 60.0 && y < 100.0;
    }
    Image picture(int t) const
    {
        Image image(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const auto grey = std::uint8_t(90 + (x * 7 + y * 13) % 40);
                const auto shade = std::uint8_t(150 + int(5 * (x - squareLeft(t)) + 3 * y) % 60);
                image.set(x, y,
                          isPost(x)           ? Rgba{20, 160, 40, 255}
                          : isSquare(t, x, y) ? Rgba{shade, 30, 30, 255}
                                              : Rgba{grey, grey, grey, 255});
            }
        return image;
    }
    // From frame t to t + step.
    FlowField flow(int t, int step) const
    {
        FlowField field{width / 2, height / 2, 2.0, {}, {}};
        for (int j = 0; j < field.height; ++j)
            for (int i = 0; i < field.width; ++i) {
                const double x = 2.0 * i + 1.0, y = 2.0 * j + 1.0;
                const bool moves = isSquare(t, x, y);
                const double there = x + (moves ? speed * step : 0.0);
                field.motions.emplace_back(float(there - x), 0.0f);
                const bool isSeenThere = moves ? isSquare(t + step, there, y) : !isSquare(t + step, x, y);
                field.confidences.push_back(isSeenThere ? 1.0f : 0.05f);
            }
        return field;
    }
    Shot shot() const
    {
        Shot shot;
        shot.width = shot.clipWidth = width;
        shot.height = shot.clipHeight = height;
        shot.cameras.assign(frames, ShotCamera{Eigen::Isometry3d::Identity(), 300.0, {160.0, 80.0}});
        for (int t = 0; t < frames; ++t) {
            const Image image = picture(t);
            shot.pictures.push_back(smallPictureOf(image));
            if (t + 1 < frames) {
                shot.forward.push_back(flow(t, 1));
                shot.backward.push_back(flow(t + 1, -1));
            }
        }
        return shot;
    }
};

double worstError(const std::vector<TrackedPoint> &track, const Vec2 &atZero)
{
    double worst = 0.0;
    for (int t = 0; t < frames; ++t)
        worst = std::max(worst, (track[std::size_t(t)].pixel - atZero - Vec2(speed * t, 0.0)).norm());
    return worst;
}

} // namespace

class TrackPointTest : public QObject
{
    Q_OBJECT
private slots:
    void followsWhatMoves_data()
    {
        QTest::addColumn<int>("keyframe");
        QTest::newRow("first") << 0;
        QTest::newRow("middle") << 11;
        QTest::newRow("last") << frames - 1;
    }
    void followsWhatMoves()
    {
        QFETCH(int, keyframe);
        const Vec2 atZero(81.3, 77.6);
        const auto track =
            trackPoint(Film().shot(), {{keyframe, atZero + Vec2(speed * keyframe, 0.0), {}, false}}, {}, {});
        QVERIFY(track.ok());
        QCOMPARE(int(track->size()), frames);
        QVERIFY2(worstError(*track, atZero) < 0.1, qPrintable(QString::number(worstError(*track, atZero))));
        for (const TrackedPoint &point : *track)
            QVERIFY(point.isVisible);
    }
    void staysOnTheGround()
    {
        const auto track = trackPoint(Film().shot(), {{3, {30.2, 20.7}, {}, false}}, {}, {});
        for (const TrackedPoint &point : *track)
            QVERIFY((point.pixel - Vec2(30.2, 20.7)).norm() < 0.1);
    }
    void passesBehindThePost()
    {
        Film film;
        film.postLeft = 120;
        film.postRight = 150;
        const Vec2 atZero(80.0, 80.0);
        const auto track = trackPoint(
            film.shot(),
            {{0, atZero, {}, false}, {frames - 1, atZero + Vec2(speed * (frames - 1), 0.0), {}, false}}, {},
            {});
        QVERIFY(track.ok());
        QVERIFY2(worstError(*track, atZero) < 6.0, qPrintable(QString::number(worstError(*track, atZero))));
        QVERIFY(!(*track)[13].isVisible); // at x 132: the middle of the post
        QVERIFY((*track)[2].isVisible && (*track)[21].isVisible);
    }
    void keyframesAreMetExactly()
    {
        // Off the thing by much: the user wants it so.
        const std::vector<CanvasKeyframe> keyframes{
            {2, {100.0, 20.0}, {}, false}, {9, {110.5, 90.0}, 6.0, false}, {20, {250.0, 130.0}, {}, false}};
        const auto track = trackPoint(Film().shot(), keyframes, {}, {});
        QVERIFY(track.ok());
        for (const CanvasKeyframe &key : keyframes)
            QVERIFY(((*track)[std::size_t(key.frame)].pixel - key.pixel).norm() < 1e-6);
        QVERIFY(std::abs((*track)[9].depth - 6.0) < 1e-9);
    }
    void wrongKeyframesAreRefused()
    {
        const Shot shot = Film().shot();
        QVERIFY(!trackPoint(shot, {}, {}, {}).ok());
        QVERIFY(!trackPoint(shot, {{frames, {10.0, 10.0}, {}, false}}, {}, {}).ok());
        QVERIFY(!trackPoint(shot, {{4, {10.0, 10.0}, {}, false}, {4, {20.0, 10.0}, {}, false}}, {}, {}).ok());
        QVERIFY(!trackPoint(shot, {{4, {std::nan(""), 10.0}, {}, false}}, {}, {}).ok());
        QVERIFY(!trackPoint(shot, {{4, {10.0, 10.0}, -1.0, false}}, {}, {}).ok());
    }
    void oneFrameIsAClipToo()
    {
        Shot shot = Film().shot();
        shot.cameras.resize(1);
        shot.pictures.resize(1);
        shot.forward.clear();
        shot.backward.clear();
        const auto track = trackPoint(shot, {{0, {33.0, 44.0}, {}, false}}, {}, {});
        QVERIFY(track.ok());
        QVERIFY((track->front().pixel - Vec2(33.0, 44.0)).norm() < 1e-9);
    }
};

QTEST_APPLESS_MAIN(TrackPointTest)
#include "track_point_test.moc"
