#include "doodling/reconstruction/rough_match.h"

#include "base/random.h"
#include "doodling/reconstruction/flow_field.h"

#include <QtTest>

using namespace ductus;

namespace {

double shade(int x, int y, int size, int salt)
{
    Random random(std::uint64_t(x / size + 1000) * 7919 + std::uint64_t(y / size + 1000) * 104729 +
                  std::uint64_t(salt));
    return random.uniform();
}

// Coloured squares of 24 pixels with a finer grain, the same for the same salt.
Rgba coloured(int x, int y, int salt)
{
    const double grain = 60.0 * shade(x, y, 5, salt);
    const auto byte = [&](int part) {
        return std::uint8_t(20.0 + grain + 150.0 * shade(x, y, 24, salt + part));
    };
    return {byte(1), byte(2), byte(3), 255};
}

// A textured square of 72 pixels before a textured ground that stands still.
Image pictureWithSquareAt(int left, int top)
{
    Image image(360, 240);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const bool isSquare = x >= left && x < left + 72 && y >= top && y < top + 72;
            image.set(x, y, isSquare ? coloured(x - left, y - top, 5) : coloured(x, y, 9));
        }
    return image;
}

} // namespace

class RoughMatchTest : public QObject
{
    Q_OBJECT
private slots:
    void aThingIsFoundFurtherThanItIsWide()
    {
        const Image from = pictureWithSquareAt(40, 60), to = pictureWithSquareAt(140, 80);
        const RoughMotionPair rough = roughMotion(windowPyramidOf(from), windowPyramidOf(to));
        const auto motionAt = [](const RoughMotion &motion, double x, double y) {
            return motion.motions[std::size_t(y / motion.cellSize) * std::size_t(motion.width) +
                                  std::size_t(x / motion.cellSize)];
        };
        QVERIFY((motionAt(rough.forward, 76, 96) - Eigen::Vector2f(100.0f, 20.0f)).norm() < 5.0f);
        QVERIFY((motionAt(rough.backward, 176, 116) + Eigen::Vector2f(100.0f, 20.0f)).norm() < 5.0f);
        QVERIFY(motionAt(rough.forward, 320, 40).norm() < 5.0f);
        QVERIFY2(rough.forward.surenessShare > 0.6, qPrintable(QString::number(rough.forward.surenessShare)));
    }
    void exactFlowStartsFromIt()
    {
        const FlowPair flow = denseFlow(pictureWithSquareAt(40, 60), pictureWithSquareAt(140, 80));
        int right = 0;
        for (double y = 72; y < 120; y += 8)
            for (double x = 52; x < 100; x += 8)
                right += (flow.forward.motionAt({x, y}) - Eigen::Vector2d(100.0, 20.0)).norm() < 1.0;
        QVERIFY2(right >= 30, qPrintable(QString::number(right))); // of 36
    }
    void theSameEveryTime()
    {
        const WindowPyramid a = windowPyramidOf(pictureWithSquareAt(40, 60)),
                            b = windowPyramidOf(pictureWithSquareAt(100, 60));
        QCOMPARE(roughMotion(a, b).forward.motions, roughMotion(a, b).forward.motions);
    }
    void tinyPicturesArePicturesToo()
    {
        for (int side : {1, 2, 9}) {
            const Image image(side, side);
            const FlowPair rough = denseFlow(image, image);
            QVERIFY(rough.forward.motionAt({0.5, 0.5}).norm() < 1e-3);
        }
    }
};

QTEST_APPLESS_MAIN(RoughMatchTest)
#include "rough_match_test.moc"
