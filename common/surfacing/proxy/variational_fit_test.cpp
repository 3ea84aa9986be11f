#include "surfacing/proxy/variational_fit.h"

#include "base/random.h"

#include <Eigen/Dense>
#include <QtTest>
#include <numbers>

using namespace ductus;

namespace {

// Evenly spread over an ellipsoid about a centre, by the golden angle.
std::vector<Vec3> onEllipsoid(int count, const Vec3 &radii, const Vec3 &centre = Vec3::Zero())
{
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 - 2.0 * (i + 0.5) / count, r = std::sqrt(1.0 - z * z);
        const double u = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
        points.push_back(centre + radii.cwiseProduct(Vec3(r * std::cos(u), r * std::sin(u), z)));
    }
    return points;
}

std::vector<Vec3> randomCloud(int count, std::uint64_t seed)
{
    Random random(seed);
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        const double x = random.uniform(-0.4, 0.4), y = random.uniform(-0.4, 0.4);
        points.push_back({x, y, random.uniform(-0.4, 0.4)});
    }
    return points;
}

// J of the published program: the top left 4n x 4n block of the inverse of [[A, N], [N^T, 0]].
Eigen::MatrixXd publishedJ(const std::vector<Vec3> &p)
{
    const int n = int(p.size());
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(4 * n + 4, 4 * n + 4);
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const Vec3 d = p[i] - p[j];
            const double r = d.norm();
            M(i, j) = r * r * r;
            for (int k = 0; k < 3; ++k) {
                M(i, n + k * n + j) = 3.0 * r * d[k];
                M(n + k * n + j, i) = 3.0 * r * d[k];
                for (int l = 0; l < 3 && r > 1e-8; ++l)
                    M(n + k * n + i, n + l * n + j) = -3.0 * (d[k] * d[l] / r + (k == l ? r : 0.0));
            }
        }
        M(i, 4 * n) = M(4 * n, i) = 1.0;
        for (int k = 0; k < 3; ++k) {
            M(i, 4 * n + 1 + k) = M(4 * n + 1 + k, i) = p[i][k];
            M(n + k * n + i, 4 * n + 1 + k) = M(4 * n + 1 + k, n + k * n + i) = -1.0;
        }
    }
    return M.inverse().topLeftCorner(4 * n, 4 * n);
}

// The published program has gradients inward; energies do not care.
Eigen::VectorXd publishedGradients(const VariationalFit &fit)
{
    const int n = int(fit.normals.size());
    Eigen::VectorXd g(3 * n);
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < 3; ++k)
            g[k * n + i] = -fit.normals[i][k];
    return g;
}

VariationalFit fitted(const std::vector<Vec3> &points, double lambda, const std::vector<Vec3> &prior = {})
{
    VariationalFitOptions options;
    options.lambda = lambda;
    Result<VariationalFit> fit = fitVariational(points, prior, options, {});
    if (!fit)
        qFatal("%s", fit.error().message().c_str());
    return std::move(*fit);
}

} // namespace

class VariationalFitTest : public QObject
{
    Q_OBJECT
private slots:
    void interpolatesValuesAndUnitGradients();
    void energyIsThePublishedQuadraticForm();
    void smoothedEnergyIsThePublishedMinimumOverValues();
    void normalsAreAMinimum();
    void sphereSamplesGiveTheSphere();
    void goodPriorIsNoWorse();
    void movesAndScalesWithItsPoints();
    void equalPointLambdasAreOneLambda();
    void largeLambdaLetsOneWildPointGo();
    void flatOrFewPointsAreRefused();
    void sameInputSameField();
    void cancelled();
};

void VariationalFitTest::interpolatesValuesAndUnitGradients()
{
    for (const std::vector<Vec3> &points :
         {onEllipsoid(50, {0.4, 0.25, 0.3}, {0.1, -0.2, 0.05}), randomCloud(25, 4)}) {
        const VariationalFit fit = fitted(points, 0.0);
        QCOMPARE(fit.normals.size(), points.size());
        QVERIFY(fit.rmsValue < 1e-9);
        constexpr double h = 1e-4;
        for (std::size_t i = 0; i < points.size(); ++i) {
            QVERIFY(std::abs(fit.field.value(points[i])) < 1e-8);
            QVERIFY(std::abs(fit.normals[i].norm() - 1.0) < 1e-9);
            Vec3 slope;
            for (int k = 0; k < 3; ++k)
                slope[k] = (fit.field.value(points[i] + h * Vec3::Unit(k)) -
                            fit.field.value(points[i] - h * Vec3::Unit(k))) /
                           (2 * h);
            // r^3 is only twice smooth at its centre: the difference quotient is off by the order of h.
            QVERIFY2((slope - fit.normals[i]).norm() < 0.02,
                     qPrintable(QString::number((slope - fit.normals[i]).norm())));
            Vec3 gradient;
            fit.field.valueAndGradient(points[i], gradient);
            QVERIFY((gradient - fit.normals[i]).norm() < 1e-7);
        }
    }
}

void VariationalFitTest::energyIsThePublishedQuadraticForm()
{
    for (std::uint64_t seed : {1, 2, 3}) {
        const std::vector<Vec3> points = randomCloud(12, seed);
        const VariationalFit fit = fitted(points, 0.0);
        Eigen::VectorXd y = Eigen::VectorXd::Zero(48);
        y.tail(36) = publishedGradients(fit);
        const double energy = y.dot(publishedJ(points) * y);
        QVERIFY2(std::abs(fit.energy - energy) < 1e-6 * energy,
                 qPrintable(QString("%1 %2").arg(fit.energy).arg(energy)));
    }
}

// Minimised over the values s: s = -lambda (I + lambda J00)^-1 J01 g, energy g^T H g.
void VariationalFitTest::smoothedEnergyIsThePublishedMinimumOverValues()
{
    for (double lambda : {1e-4, 1e-3, 1e-2}) {
        const std::vector<Vec3> points = randomCloud(12, 7);
        const int n = 12;
        const VariationalFit fit = fitted(points, lambda);
        const Eigen::MatrixXd J = publishedJ(points);
        const Eigen::MatrixXd J00 = J.topLeftCorner(n, n), J01 = J.topRightCorner(n, 3 * n);
        const Eigen::VectorXd g = publishedGradients(fit);
        const Eigen::MatrixXd inner = Eigen::MatrixXd::Identity(n, n) + lambda * J00;
        const Eigen::VectorXd s = -lambda * inner.partialPivLu().solve(J01 * g);
        Eigen::VectorXd y(4 * n);
        y << s, g;
        const double energy = s.squaredNorm() / lambda + y.dot(J * y);
        QVERIFY2(std::abs(fit.energy - energy) < 1e-6 * energy,
                 qPrintable(QString("%1 %2").arg(fit.energy).arg(energy)));
        for (int i = 0; i < n; ++i)
            QVERIFY(std::abs(fit.field.value(points[i]) - s[i]) < 1e-7);
        QVERIFY(std::abs(fit.rmsValue - std::sqrt(s.squaredNorm() / n)) < 1e-8);
        // And no other values give less.
        Random random(3);
        for (int trial = 0; trial < 20; ++trial) {
            Eigen::VectorXd other = y;
            for (int i = 0; i < n; ++i)
                other[i] += 0.01 * random.normal();
            QVERIFY(other.head(n).squaredNorm() / lambda + other.dot(J * other) > energy);
        }
    }
}

void VariationalFitTest::normalsAreAMinimum()
{
    const std::vector<Vec3> points = onEllipsoid(12, {0.4, 0.25, 0.3});
    const VariationalFit fit = fitted(points, 0.0);
    const Eigen::MatrixXd H = publishedJ(points).bottomRightCorner(36, 36);
    const Eigen::VectorXd g = publishedGradients(fit);
    Random random(5);
    for (int trial = 0; trial < 200; ++trial) { // turn one normal by a few degrees
        const int i = random.index(12);
        Vec3 n(g[i], g[12 + i], g[24 + i]);
        n = (n + 0.05 * Vec3(random.normal(), random.normal(), random.normal())).normalized();
        Eigen::VectorXd other = g;
        for (int k = 0; k < 3; ++k)
            other[12 * k + i] = n[k];
        QVERIFY(other.dot(H * other) > fit.energy - 1e-5 * fit.energy);
    }
}

void VariationalFitTest::sphereSamplesGiveTheSphere()
{
    const double radius = 0.3;
    const Vec3 centre(0.1, 0.05, -0.1);
    const VariationalFit fit = fitted(onEllipsoid(80, Vec3::Constant(radius), centre), 0.0);
    Random random(8);
    Vec3 gradient;
    fit.field.valueAndGradient(centre + radius * Vec3::UnitX(), gradient);
    const double sign = gradient.x() > 0 ? 1.0 : -1.0; // without a prior the inside is anyone's choice
    for (int i = 0; i < 300; ++i) {
        const Vec3 u = Vec3(random.normal(), random.normal(), random.normal()).normalized();
        QVERIFY(sign * fit.field.value(centre + 0.995 * radius * u) < 0.0);
        QVERIFY(sign * fit.field.value(centre + 1.005 * radius * u) > 0.0);
    }
    for (std::size_t i = 0; i < fit.normals.size(); ++i) {
        const Vec3 outwards = (onEllipsoid(80, Vec3::Ones())[i]);
        QVERIFY(sign * fit.normals[i].dot(outwards) > 0.999);
    }
}

void VariationalFitTest::goodPriorIsNoWorse()
{
    const std::vector<Vec3> points = onEllipsoid(60, {0.4, 0.2, 0.3});
    std::vector<Vec3> prior;
    for (const Vec3 &p : points)
        prior.push_back(2.0 * p.normalized());
    const VariationalFit without = fitted(points, 1e-5), with = fitted(points, 1e-5, prior);
    QVERIFY(with.energy <= without.energy * (1 + 1e-9));
    int outwards = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        outwards += with.normals[i].dot(points[i]) > 0.0;
    QVERIFY(outwards == 0 || outwards == 60); // consistent
    // Useless hints do no harm.
    const VariationalFit zero = fitted(points, 1e-5, std::vector<Vec3>(points.size(), Vec3::Zero()));
    QVERIFY(zero.energy <= without.energy * (1 + 1e-9));
}

void VariationalFitTest::movesAndScalesWithItsPoints()
{
    const std::vector<Vec3> points = onEllipsoid(40, {0.4, 0.2, 0.3});
    std::vector<Vec3> moved;
    const Vec3 shift(0.3, -0.2, 0.4);
    for (const Vec3 &p : points)
        moved.push_back(p + shift);
    const VariationalFit here = fitted(points, 1e-4), there = fitted(moved, 1e-4);
    QVERIFY(std::abs(here.energy - there.energy) < 1e-6 * here.energy);
}

void VariationalFitTest::equalPointLambdasAreOneLambda()
{
    const std::vector<Vec3> points = randomCloud(20, 3);
    VariationalFitOptions options;
    options.pointLambdas.assign(20, 1e-3);
    const auto each = fitVariational(points, {}, options, {});
    QVERIFY(each.ok());
    const VariationalFit one = fitted(points, 1e-3);
    QVERIFY(each->energy == one.energy);
    QVERIFY(each->normals == one.normals);
}

void VariationalFitTest::largeLambdaLetsOneWildPointGo()
{
    std::vector<Vec3> points = onEllipsoid(60, Vec3::Constant(0.3));
    points.push_back({0.36, 0, 0});
    VariationalFitOptions options;
    options.pointLambdas.assign(61, 0.0);
    const auto strict = fitVariational(points, {}, options, {});
    options.pointLambdas.back() = 1.0;
    const auto loose = fitVariational(points, {}, options, {});
    QVERIFY(strict.ok() && loose.ok());
    QVERIFY(std::abs(strict->field.value(points.back())) < 1e-8);
    QVERIFY(std::abs(loose->field.value(points.back())) > 0.03);
    for (int i = 0; i < 60; ++i)
        QVERIFY(std::abs(loose->field.value(points[i])) < 1e-8);
    QVERIFY(loose->energy < strict->energy);
}

void VariationalFitTest::flatOrFewPointsAreRefused()
{
    std::vector<Vec3> flat = randomCloud(30, 1);
    for (Vec3 &p : flat)
        p.z() = 0.3 * p.x() - 0.2 * p.y();
    const auto refused = fitVariational(flat, {}, {}, {});
    QVERIFY(!refused.ok());
    QCOMPARE(refused.error().code, ErrorCode::NoSolution);
    QVERIFY(!refused.error().remedy.empty());
    for (int count : {0, 1, 3, 7}) {
        const auto few = fitVariational(randomCloud(count, 1), {}, {}, {});
        QVERIFY(!few.ok());
        QCOMPARE(few.error().code, ErrorCode::TooLittleData);
    }
    QVERIFY(!fitVariational(std::vector<Vec3>(20, Vec3(0.1, 0.2, 0.3)), {}, {}, {}).ok());
    std::vector<Vec3> onALine;
    for (int i = 0; i < 20; ++i)
        onALine.push_back(0.05 * i * Vec3(1, 2, 3));
    QVERIFY(!fitVariational(onALine, {}, {}, {}).ok());
}

void VariationalFitTest::sameInputSameField()
{
    const std::vector<Vec3> points = randomCloud(60, 2);
    const VariationalFit first = fitted(points, 1e-4), again = fitted(points, 1e-4);
    QVERIFY(first.energy == again.energy);
    QVERIFY(first.normals == again.normals);
    QVERIFY(first.field.value({0.1, 0.1, 0.1}) == again.field.value({0.1, 0.1, 0.1}));
}

void VariationalFitTest::cancelled()
{
    const std::atomic<bool> cancel = true;
    const auto fit = fitVariational(randomCloud(60, 2), {}, {}, JobControl(&cancel, {}));
    QVERIFY(!fit.ok());
    QVERIFY(fit.error().isCancelled());
}

QTEST_APPLESS_MAIN(VariationalFitTest)
#include "variational_fit_test.moc"
