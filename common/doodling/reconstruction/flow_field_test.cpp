#include "doodling/reconstruction/flow_field.h"

#include "base/random.h"

#include <QtTest>

using namespace ductus;

namespace {

double lattice(int x, int y, int salt)
{
    Random random(std::uint64_t(x + 1000) * 7919 + std::uint64_t(y + 1000) * 104729 + std::uint64_t(salt));
    return random.uniform();
}

// Blobs of three sizes, 0..255.
double texture(double x, double y, int salt)
{
    double grey = 0.0;
    for (double size : {24.0, 9.0, 4.0}) {
        const double u = x / size, v = y / size;
        const int i = int(std::floor(u)), j = int(std::floor(v));
        const double fu = u - i, fv = v - j;
        grey += 85.0 * ((lattice(i, j, salt) * (1 - fu) + lattice(i + 1, j, salt) * fu) * (1 - fv) +
                        (lattice(i, j + 1, salt) * (1 - fu) + lattice(i + 1, j + 1, salt) * fu) * fv);
    }
    return grey;
}

// A picture moved by (dx, dy); a square of other texture in front moves on its own.
Image scene(double dx, double dy, double squareDx = 0.0, bool hasSquare = false)
{
    Image image(240, 160);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double left = 80.0 + squareDx;
            const bool isSquare = hasSquare && x >= left && x < left + 60.0 && y >= 50 && y < 110;
            const auto value =
                std::uint8_t(isSquare ? texture(x - squareDx, y, 2) : texture(x - dx, y - dy, 1));
            image.set(x, y, {value, value, value, 255});
        }
    return image;
}

} // namespace

class FlowFieldTest : public QObject
{
    Q_OBJECT
private slots:
    void aShiftIsFound()
    {
        const FlowPair flow = denseFlow(scene(0, 0), scene(3.5, -2.0));
        QCOMPARE(flow.forward.width, 60);
        QCOMPARE(flow.forward.height, 40);
        for (double y = 20; y < 140; y += 7.3)
            for (double x = 20; x < 220; x += 7.7) {
                QVERIFY((flow.forward.motionAt({x, y}) - Eigen::Vector2d(3.5, -2.0)).norm() < 0.3);
                QVERIFY((flow.backward.motionAt({x, y}) + Eigen::Vector2d(3.5, -2.0)).norm() < 0.3);
                QVERIFY(flow.forward.confidenceAt({x, y}) > 0.7);
            }
    }
    void whatIsCoveredIsNotTrusted()
    {
        // The square moves right by ten and covers what was right of it.
        const FlowPair flow = denseFlow(scene(0, 0, 0.0, true), scene(0, 0, 10.0, true));
        QVERIFY((flow.forward.motionAt({110.0, 80.0}) - Eigen::Vector2d(10.0, 0.0)).norm() < 0.5);
        QVERIFY(flow.forward.motionAt({30.0, 30.0}).norm() < 0.3);
        double covered = 0.0, seen = 0.0;
        for (double y = 60; y < 100; y += 4) {
            covered += flow.forward.confidenceAt({145.0, y}) / 10;
            seen += flow.forward.confidenceAt({190.0, y}) / 10;
        }
        QVERIFY2(covered < 0.4 && seen > 0.8, qPrintable(QString("%1 %2").arg(covered).arg(seen)));
    }
    void placesOutsideCountAsTheBorder()
    {
        FlowField field{2, 1, 4.0, {{1.0f, 0.0f}, {3.0f, 2.0f}}, {0.2f, 0.6f}};
        QCOMPARE(field.motionAt({-50.0, 9.0}), Eigen::Vector2d(1.0, 0.0));
        QCOMPARE(field.motionAt({50.0, -9.0}), Eigen::Vector2d(3.0, 2.0));
        QVERIFY((field.motionAt({4.0, 2.0}) - Eigen::Vector2d(2.0, 1.0)).norm() < 1e-6);
        QVERIFY(std::abs(field.confidenceAt({4.0, 2.0}) - 0.4) < 1e-6);
    }
};

QTEST_APPLESS_MAIN(FlowFieldTest)
#include "flow_field_test.moc"
