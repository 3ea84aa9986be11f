#include "surfacing/proxy/lambda_choice.h"

#include "base/random.h"

#include <QtTest>
#include <numbers>

using namespace ductus;

namespace {

// Circles of latitude and longitude on a sphere of radius 0.35, each moved off it by up to \a noise.
std::vector<Vec3> globe(double noise)
{
    Random random(2);
    std::vector<Vec3> points;
    for (int line = 0; line < 12; ++line) {
        const double radius = 0.35 + random.uniform(-noise, noise);
        for (int i = 0; i < 60; ++i) {
            const double u = 2.0 * std::numbers::pi * i / 60, w = std::numbers::pi * (line / 2 + 0.5) / 6;
            points.push_back(
                line % 2 ? radius * Vec3(std::sin(w) * std::cos(u), std::sin(w) * std::sin(u), std::cos(w))
                         : radius * Vec3(std::cos(u) * std::cos(w), std::cos(u) * std::sin(w), std::sin(u)));
        }
    }
    return points;
}

double chosen(double noise, const LambdaChoiceOptions &options, bool isShell = false, int fitPoints = 600)
{
    const Result<double> lambda = chooseLambda(globe(noise), fitPoints, isShell, options, {});
    if (!lambda)
        qFatal("%s", lambda.error().message().c_str());
    return *lambda;
}

LambdaChoiceOptions few()
{
    LambdaChoiceOptions options;
    options.points = 120;
    return options;
}

} // namespace

class LambdaChoiceTest : public QObject
{
    Q_OBJECT
private slots:
    void cleanStrokesNeedTheLeast();
    void strokesThatMissEachOtherNeedMore();
    void intricateShapesTakeTheLargestWithinTheNoise();
    void growsWithTheNumberOfPoints();
    void oneChoiceIsTaken();
    void flatSketchIsRefused();
    void cancelled();
};

void LambdaChoiceTest::cleanStrokesNeedTheLeast()
{
    QVERIFY(std::abs(chosen(0.0, few()) - few().lambdas.front()) < 1e-15);
}

void LambdaChoiceTest::strokesThatMissEachOtherNeedMore()
{
    LambdaChoiceOptions options;
    options.points = 240;
    const double clean = chosen(0.0, options, true), drawn = chosen(0.02, options, true);
    QVERIFY2(drawn > 2.0 * clean, qPrintable(QString::number(drawn)));
    QVERIFY(drawn <= options.lambdas.back() * (1 + 1e-12));
}

void LambdaChoiceTest::intricateShapesTakeTheLargestWithinTheNoise()
{
    LambdaChoiceOptions options = few();
    options.calmEnergy = 0.0; // never calm
    options.solidNoise = 1e9;
    QVERIFY(std::abs(chosen(0.01, options) / options.lambdas.back() - 1.0) < 1e-12);
    options.solidNoise = 0.0;
    QVERIFY(std::abs(chosen(0.01, options) / options.lambdas.front() - 1.0) < 1e-12);
    options.shellNoise = 1e9;
    QVERIFY(std::abs(chosen(0.01, options, true) / options.lambdas.back() - 1.0) < 1e-12);
    double before = 0.0;
    for (double noise : {0.001, 0.003, 0.01, 0.03}) {
        options.solidNoise = noise;
        const double lambda = chosen(0.01, options);
        QVERIFY(lambda >= before);
        before = lambda;
    }
}

void LambdaChoiceTest::growsWithTheNumberOfPoints()
{
    const double full = chosen(0.02, few(), false, 600), half = chosen(0.02, few(), false, 300);
    QVERIFY(std::abs(half - 0.5 * full) < 1e-12 * full);
}

void LambdaChoiceTest::oneChoiceIsTaken()
{
    LambdaChoiceOptions options = few();
    options.lambdas = {2e-4};
    QVERIFY(std::abs(chosen(0.02, options) - 2e-4) < 1e-15);
    QVERIFY(std::abs(chosen(0.0, options) - 2e-4) < 1e-15);
}

void LambdaChoiceTest::flatSketchIsRefused()
{
    std::vector<Vec3> points = globe(0.0);
    for (Vec3 &p : points)
        p.z() = 0.0;
    const auto lambda = chooseLambda(points, 600, false, few(), {});
    QVERIFY(!lambda.ok());
    QCOMPARE(lambda.error().code, ErrorCode::NoSolution);
}

void LambdaChoiceTest::cancelled()
{
    const std::atomic<bool> cancel = true;
    const auto lambda = chooseLambda(globe(0.0), 600, false, few(), JobControl(&cancel, {}));
    QVERIFY(!lambda.ok());
    QVERIFY(lambda.error().isCancelled());
}

QTEST_APPLESS_MAIN(LambdaChoiceTest)
#include "lambda_choice_test.moc"
