#include "surfacing/segmentation/implicit_polynomial.h"

#include "base/random.h"

#include <QtTest>
#include <array>

using namespace ductus;

namespace {

Vec3 randomVec(Random &random, double size = 1.0)
{
    const double x = random.uniform(-size, size), y = random.uniform(-size, size);
    return {x, y, random.uniform(-size, size)};
}

ImplicitPolynomial randomPolynomial(int degree, Random &random)
{
    ImplicitPolynomial model{degree, randomVec(random, 0.3), Eigen::VectorXd(monomialCount(degree))};
    for (Eigen::Index k = 0; k < model.theta.size(); ++k)
        model.theta[k] = random.uniform(-1.0, 1.0);
    return model;
}

// x^2 + y^2 + z^2 - r^2 about a centre.
ImplicitPolynomial sphere(const Vec3 &centre, double radius)
{
    ImplicitPolynomial model{2, centre, Eigen::VectorXd::Zero(10)};
    model.theta[0] = -radius * radius;
    model.theta[4] = model.theta[7] = model.theta[9] = 1.0;
    return model;
}

void addDegrees()
{
    QTest::addColumn<int>("degree");
    for (int degree = 1; degree <= maxPolynomialDegree; ++degree)
        QTest::addRow("degree %d", degree) << degree;
}

} // namespace

class ImplicitPolynomialTest : public QObject
{
    Q_OBJECT
private slots:
    void countsMonomials();
    void ordersMonomialsByDegree();
    void gradientAgreesWithDifferences_data() { addDegrees(); }
    void gradientAgreesWithDifferences();
    void monomialDerivativesAgreeWithDifferences();
    void mirroredIsTheModelOfTheMirroredPoint_data() { addDegrees(); }
    void mirroredIsTheModelOfTheMirroredPoint();
    void mirroringTwiceGivesTheModelBack();
    void distanceToAPlaneIsExact();
    void distanceToASphereIsTaubins();
    void distanceWithoutGradientStaysFinite();
};

void ImplicitPolynomialTest::countsMonomials()
{
    QCOMPARE(monomialCount(1), 4);
    QCOMPARE(monomialCount(2), 10);
    QCOMPARE(monomialCount(3), 20);
    QCOMPARE(monomialCount(4), maxMonomialCount);
}

void ImplicitPolynomialTest::ordersMonomialsByDegree()
{
    double values[maxMonomialCount];
    evaluateMonomials({2, 3, 5}, 2, values);
    const std::array<double, 10> expected{1, 2, 3, 5, 4, 6, 10, 9, 15, 25};
    QVERIFY(std::equal(expected.begin(), expected.end(), values));
    // A lower degree is the beginning of a higher one.
    double quartic[maxMonomialCount];
    evaluateMonomials({2, 3, 5}, 4, quartic);
    QVERIFY(std::equal(expected.begin(), expected.end(), quartic));
    QCOMPARE(quartic[10], 8.0);
    QCOMPARE(quartic[34], 625.0);
}

void ImplicitPolynomialTest::gradientAgreesWithDifferences()
{
    QFETCH(int, degree);
    Random random(11);
    for (int trial = 0; trial < 50; ++trial) {
        const ImplicitPolynomial model = randomPolynomial(degree, random);
        const Vec3 p = randomVec(random);
        Vec3 gradient;
        QVERIFY(std::abs(model.valueAndGradient(p, gradient) - model.value(p)) < 1e-13);
        constexpr double h = 1e-5;
        for (int k = 0; k < 3; ++k) {
            const double slope =
                (model.value(p + h * Vec3::Unit(k)) - model.value(p - h * Vec3::Unit(k))) / (2 * h);
            QVERIFY2(std::abs(slope - gradient[k]) < 1e-7, qPrintable(QString::number(slope - gradient[k])));
        }
    }
}

void ImplicitPolynomialTest::monomialDerivativesAgreeWithDifferences()
{
    const Vec3 p(0.3, -0.7, 0.4);
    constexpr double h = 1e-5;
    double values[maxMonomialCount], d[3][maxMonomialCount];
    evaluateMonomials(p, 4, values, d[0], d[1], d[2]);
    for (int k = 0; k < 3; ++k) {
        double up[maxMonomialCount], down[maxMonomialCount];
        evaluateMonomials(p + h * Vec3::Unit(k), 4, up);
        evaluateMonomials(p - h * Vec3::Unit(k), 4, down);
        for (int m = 0; m < maxMonomialCount; ++m)
            QVERIFY(std::abs((up[m] - down[m]) / (2 * h) - d[k][m]) < 1e-8);
    }
}

void ImplicitPolynomialTest::mirroredIsTheModelOfTheMirroredPoint()
{
    QFETCH(int, degree);
    Random random(5);
    for (int trial = 0; trial < 20; ++trial) {
        const ImplicitPolynomial model = randomPolynomial(degree, random);
        const Vec3 normal = randomVec(random).normalized();
        const double offset = random.uniform(-0.5, 0.5);
        const ImplicitPolynomial image = mirrored(model, normal, offset);
        QCOMPARE(image.degree, degree);
        for (int i = 0; i < 20; ++i) {
            const Vec3 p = randomVec(random);
            const Vec3 mirrorPoint = p - 2.0 * (normal.dot(p) - offset) * normal;
            Vec3 gradient, imageGradient;
            const double expected = model.valueAndGradient(mirrorPoint, gradient);
            QVERIFY(std::abs(image.valueAndGradient(p, imageGradient) - expected) < 1e-10);
            const Vec3 turned = gradient - 2.0 * normal.dot(gradient) * normal;
            QVERIFY((imageGradient - turned).norm() < 1e-9);
        }
    }
}

void ImplicitPolynomialTest::mirroringTwiceGivesTheModelBack()
{
    Random random(8);
    const ImplicitPolynomial model = randomPolynomial(4, random);
    const Vec3 normal = Vec3(1, 2, -2) / 3.0;
    const ImplicitPolynomial twice = mirrored(mirrored(model, normal, 0.2), normal, 0.2);
    QVERIFY((twice.origin - model.origin).norm() < 1e-12);
    QVERIFY((twice.theta - model.theta).cwiseAbs().maxCoeff() < 1e-10);
}

void ImplicitPolynomialTest::distanceToAPlaneIsExact()
{
    ImplicitPolynomial plane{1, {0.1, 0.2, 0.3}, Eigen::VectorXd(4)};
    plane.theta << -3.0, 0.0, 6.0, 8.0; // normal (0, 0.6, 0.8), 0.3 beyond the origin of the model
    Vec3 normal;
    QVERIFY(std::abs(plane.signedDistance({0.1, 0.2, 0.3}, &normal) + 0.3) < 1e-14);
    QVERIFY((normal - Vec3(0, 0.6, 0.8)).norm() < 1e-14);
    QVERIFY(std::abs(plane.signedDistance(Vec3(0.1, 0.2, 0.3) + 2.3 * Vec3(0, 0.6, 0.8)) - 2.0) < 1e-13);
}

void ImplicitPolynomialTest::distanceToASphereIsTaubins()
{
    const Vec3 centre(0.2, -0.1, 0.4);
    const ImplicitPolynomial model = sphere(centre, 0.5);
    for (double r : {0.1, 0.45, 0.5, 0.55, 2.0}) {
        Vec3 normal;
        const Vec3 outwards = Vec3(2, -1, 2) / 3.0;
        const double distance = model.signedDistance(centre + r * outwards, &normal);
        QVERIFY(std::abs(distance - (r * r - 0.25) / (2 * r)) < 1e-12);
        QVERIFY((normal - outwards).norm() < 1e-12);
    }
}

void ImplicitPolynomialTest::distanceWithoutGradientStaysFinite()
{
    const ImplicitPolynomial model = sphere(Vec3::Zero(), 0.5);
    const double atCentre = model.signedDistance(Vec3::Zero());
    QVERIFY(std::isfinite(atCentre));
    QVERIFY(atCentre < -1e3);
    // Where value and gradient both vanish there is nothing to divide either.
    ImplicitPolynomial zero{3, Vec3::Zero(), Eigen::VectorXd::Zero(20)};
    Vec3 normal;
    QCOMPARE(zero.signedDistance({1, 2, 3}, &normal), 0.0);
    QVERIFY(normal.allFinite());
}

QTEST_APPLESS_MAIN(ImplicitPolynomialTest)
#include "implicit_polynomial_test.moc"
