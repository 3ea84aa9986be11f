#include "doodling/reconstruction/depth/moving_cells.h"

#include <QtTest>

using namespace ductus;

namespace {

constexpr int width = 40, height = 24, cell = 4;

bool isThing(int x, int y)
{
    return x >= 14 && x < 22 && y >= 8 && y < 16;
}

// A picture full of corners, in which a thing moves otherwise than the rest.
std::vector<float> likelihoods(float stillMiss, float thingMiss)
{
    Image image(width * cell, height * cell);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const auto grey = std::uint8_t((x / cell * 37 + y / cell * 91) % 200 + 20);
            const bool isIn = isThing(x / cell, y / cell);
            image.set(x, y, {grey, isIn ? std::uint8_t(10) : grey, grey, 255});
        }
    OwnMotion motion;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            motion.pixels.push_back(isThing(x, y) ? thingMiss : stillMiss);
            motion.trusts.push_back(1.0f);
        }
    return movingLikelihood(motion, edgeWeights(image, cell, 12.0), 854.0);
}

// Of the thing and of the rest, means.
std::pair<float, float> means(const std::vector<float> &values)
{
    float thing = 0.0f, rest = 0.0f;
    int count = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            (isThing(x, y) ? thing : rest) += values[std::size_t(y * width + x)];
            count += isThing(x, y);
        }
    return {thing / float(count), rest / float(width * height - count)};
}

} // namespace

class MovingCellsTest : public QObject
{
    Q_OBJECT
private slots:
    void whatMovesOtherwiseIsToldFromTheRest()
    {
        const auto [thing, rest] = means(likelihoods(0.1f, 2.2f));
        QVERIFY2(thing > 0.6f && rest < 0.1f, qPrintable(QString("%1 %2").arg(thing).arg(rest)));
    }
    // Where the camera's place is wrong, or the frame is smeared, everything misses.
    void whatAllMissesByIsNoMotion()
    {
        const auto [thing, rest] = means(likelihoods(1.6f, 1.6f));
        QVERIFY2(thing < 0.1f && rest < 0.1f, qPrintable(QString("%1 %2").arg(thing).arg(rest)));
        const auto [fast, behind] = means(likelihoods(1.0f, 8.0f));
        QVERIFY2(fast > 0.6f && behind < 0.1f, qPrintable(QString("%1 %2").arg(fast).arg(behind)));
    }
    void nothingSeenAgainIsNothingMoving()
    {
        OwnMotion motion;
        motion.pixels.assign(width * height, 0.0f);
        motion.trusts.assign(width * height, 0.0f);
        const Image plain(width * cell, height * cell);
        for (float likelihood : movingLikelihood(motion, edgeWeights(plain, cell, 12.0), 854.0))
            QCOMPARE(likelihood, 0.0f);
    }
};

QTEST_APPLESS_MAIN(MovingCellsTest)
#include "moving_cells_test.moc"
