// The parts light is made of: colours, lamps, shadow maps, the shadow on the ground.
#include "imaging/picture/colour.h"
#include "imaging/picture/ground.h"
#include "imaging/picture/lights.h"
#include "imaging/picture/shadow_map.h"

#include <QtTest>
#include <cmath>
#include <numbers>

using namespace ductus;
using namespace ductus::picture;

namespace {

// A horizontal square of half width \a half at height \a y.
Stage roof(double y, double half)
{
    const Vec3 a(-half, y, -half), b(half, y, -half), c(half, y, half), d(-half, y, half);
    Stage stage;
    for (const auto &corners : {std::array<Vec3, 3>{a, c, b}, std::array<Vec3, 3>{a, d, c}}) {
        StageTriangle triangle;
        triangle.corners = corners;
        triangle.normals.fill(Vec3::UnitY());
        triangle.faceNormal = Vec3::UnitY();
        stage.triangles.push_back(triangle);
    }
    return stage;
}

} // namespace

class LightTest : public QObject
{
    Q_OBJECT
private slots:
    void bytesSurviveTheWayToLinearAndBack();
    void lampsAddUpToWhatTheyPromise();
    void shadowFallsWhereTheRaysSay();
    void groundIsDarkUnderARoofAndFadesOutwards();
};

void LightTest::bytesSurviveTheWayToLinearAndBack()
{
    for (int i = 0; i < 256; ++i) {
        const Rgba colour{std::uint8_t(i), std::uint8_t(255 - i), std::uint8_t(i / 2), 255};
        QCOMPARE(rgbaFromLinear(linearFromRgba(colour)), colour);
    }
    // Half the light is sRGB 188; cut beyond the ends.
    QCOMPARE(rgbaFromLinear(Vec3(0.5, -3.0, 7.0)), (Rgba{188, 0, 255, 255}));
}

void LightTest::lampsAddUpToWhatTheyPromise()
{
    for (double azimuth : {0.0, 35.0, 200.0}) {
        const Lights lights = studioLights(azimuth);
        double sky = 0.0, key = 0.0;
        for (const Lamp &lamp : lights.sky) {
            QVERIFY(std::abs(lamp.towards.norm() - 1.0) < 1e-12);
            QVERIFY(lamp.towards.y() > 0.0);
            sky += lamp.strength * lamp.towards.y();
        }
        for (const Lamp &lamp : lights.key) {
            QVERIFY(lamp.towards.dot(lights.towardsKey) > std::cos(12.0 * std::numbers::pi / 180.0));
            key += lamp.strength * lamp.towards.dot(lights.towardsKey);
        }
        QVERIFY(std::abs(sky - 1.0) < 1e-12);
        QVERIFY(std::abs(key - 1.0) < 1e-12);
    }
}

void LightTest::shadowFallsWhereTheRaysSay()
{
    const Vec3 towards = Vec3(1.0, 2.0, 0.5).normalized();
    const double height = 0.25, half = 0.2;
    const ShadowMap map(roof(height, half), towards, 256);
    const double blur = 2.0 * map.cellSize() / towards.y();
    int dark = 0, bright = 0;
    for (int i = -20; i <= 20; ++i) {
        for (int j = -20; j <= 20; ++j) {
            const Vec3 place(0.02 * i, -0.05, 0.02 * j);
            const Vec3 hit = place + (height - place.y()) / towards.y() * towards;
            const double inside = half - std::max(std::abs(hit.x()), std::abs(hit.z()));
            const double lit = map.lit(place, 1e-3);
            if (inside > blur) {
                QCOMPARE(lit, 0.0);
                ++dark;
            } else if (inside < -blur) {
                QCOMPARE(lit, 1.0);
                ++bright;
            }
        }
    }
    QVERIFY(dark > 100 && bright > 100);
    QCOMPARE(map.lit(Vec3(0, height + 0.01, 0), 1e-3), 1.0); // above the roof
    QCOMPARE(map.lit(Vec3(0, height, 0), 0.02), 1.0);        // the roof does not shade itself
    QCOMPARE(map.lit(Vec3(9, -9, 9), 0.0), 1.0);             // beyond the map
}

void LightTest::groundIsDarkUnderARoofAndFadesOutwards()
{
    Stage stage = roof(0.1, 0.3);
    stage.groundHeight = 0.0;
    const Ground ground(stage, studioLights(0.0));
    const double middle = ground.shadow(0.0, 0.0);
    QVERIFY(middle > 0.75 && middle <= 1.0);
    double before = middle;
    for (double x : {0.35, 0.6, 1.0, 1.5}) {
        const double shadow = ground.shadow(x, 0.0);
        QVERIFY(shadow <= before);
        before = shadow;
    }
    QVERIFY(before < 0.02);
    QCOMPARE(ground.shadow(2.0, 0.0), 0.0);
    // Closer to the ground is darker.
    Stage low = roof(0.02, 0.3);
    QVERIFY(Ground(low, studioLights(0.0)).shadow(0.0, 0.0) > middle);
    QCOMPARE(Ground(Stage(), studioLights(0.0)).shadow(0.0, 0.0), 0.0);
}

QTEST_APPLESS_MAIN(LightTest)
#include "light_test.moc"
