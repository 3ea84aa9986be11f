#include "surfacing/segmentation/model_fit.h"

#include "base/random.h"

#include <Eigen/QR>
#include <QtTest>
#include <numeric>

using namespace ductus;

namespace {

std::vector<int> all(const std::vector<OrientedPoint> &points)
{
    std::vector<int> indices(points.size());
    std::iota(indices.begin(), indices.end(), 0);
    return indices;
}

ImplicitPolynomial fitAll(const std::vector<OrientedPoint> &points, int degree,
                          const ModelFitOptions &options)
{
    return fitPolynomial(points, all(points), degree, options);
}

std::vector<OrientedPoint> planeSamples(const Vec3 &normal, double offset, int count)
{
    Random random(1);
    std::vector<OrientedPoint> points;
    while (int(points.size()) < count) {
        const double x = random.uniform(-0.5, 0.5), y = random.uniform(-0.5, 0.5);
        const Vec3 p(x, y, random.uniform(-0.5, 0.5));
        points.push_back({p - (normal.dot(p) - offset) * normal, normal});
    }
    return points;
}

// A patch of a sphere, or with \a flatAxis of a cylinder along z.
std::vector<OrientedPoint> roundSamples(double radius, bool isCylinder, int count)
{
    Random random(2);
    std::vector<OrientedPoint> points;
    for (int i = 0; i < count; ++i) {
        const double u = random.uniform(-1.2, 1.2), v = random.uniform(-1.0, 1.0);
        const Vec3 n = isCylinder ? Vec3(std::cos(u), std::sin(u), 0)
                                  : Vec3(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
        points.push_back({radius * n + (isCylinder ? Vec3(0, 0, 0.3 * v) : Vec3::Zero()), n});
    }
    return points;
}

double worstDistance(const ImplicitPolynomial &model, const std::vector<OrientedPoint> &points)
{
    double worst = 0.0;
    for (const OrientedPoint &p : points)
        worst = std::max(worst, std::abs(model.signedDistance(p.point)));
    return worst;
}

// Columns' means and standard deviations of the monomials about the centroid, and the whole objective of Eq.
// III.6 as one stack of equations R hat = target.
struct Objective
{
    Eigen::MatrixXd rows;
    Eigen::VectorXd target;
    Eigen::VectorXd mean, scale;

    Objective(const std::vector<OrientedPoint> &points, int degree, double mu, double lambda)
    {
        const int n = int(points.size()), t = monomialCount(degree);
        Vec3 centroid = Vec3::Zero();
        for (const OrientedPoint &p : points)
            centroid += p.point / n;
        Eigen::MatrixXd M(n, t), B(n, t);
        for (int i = 0; i < n; ++i) {
            std::vector<double> m(t), d[3] = {m, m, m};
            evaluateMonomials(points[i].point - centroid, degree, m.data(), d[0].data(), d[1].data(),
                              d[2].data());
            for (int k = 0; k < t; ++k) {
                M(i, k) = m[k];
                B(i, k) = points[i].normal.dot(Vec3(d[0][k], d[1][k], d[2][k]));
            }
        }
        mean = M.colwise().mean().transpose();
        scale = (M.rowwise() - mean.transpose()).colwise().squaredNorm().transpose();
        scale = (scale / n).cwiseSqrt();
        mean[0] = 0.0;
        scale[0] = 1.0;
        rows.setZero(2 * n + t, t);
        target.setZero(2 * n + t);
        rows.topRows(n) = (M.rowwise() - mean.transpose()) * scale.cwiseInverse().asDiagonal();
        rows.middleRows(n, n) = std::sqrt(mu) * B * scale.cwiseInverse().asDiagonal();
        target.segment(n, n).setConstant(std::sqrt(mu));
        rows.bottomRows(t).diagonal().setConstant(std::sqrt(lambda));
    }

    Eigen::VectorXd hatOf(const ImplicitPolynomial &model) const
    {
        Eigen::VectorXd hat = model.theta.cwiseProduct(scale);
        hat[0] += mean.dot(model.theta);
        return hat;
    }
    double operator()(const Eigen::VectorXd &hat) const { return (rows * hat - target).squaredNorm(); }
};

} // namespace

class ModelFitTest : public QObject
{
    Q_OBJECT
private slots:
    void recoversAPlane();
    void recoversASphereAndACylinder();
    void gradientPointsAlongTheNormals();
    void minimisesTheObjective_data();
    void minimisesTheObjective();
    void movesWithItsPoints();
    void boostScalesBothRegularisers();
    void seesOnlyItsSubset();
    void fewPointsGiveAPlaneThroughThem();
    void pointsInACoordinatePlaneGiveThatPlane();
};

void ModelFitTest::recoversAPlane()
{
    const Vec3 normal = Vec3(1, -2, 2) / 3.0;
    const std::vector<OrientedPoint> points = planeSamples(normal, 0.1, 200);
    for (int degree = 1; degree <= maxPolynomialDegree; ++degree) {
        const ImplicitPolynomial model = fitAll(points, degree, {});
        QVERIFY2(worstDistance(model, points) < 2e-3,
                 qPrintable(QString::number(worstDistance(model, points))));
    }
    ModelFitOptions exact;
    exact.regularisation = 1e-9;
    QVERIFY(worstDistance(fitAll(points, 1, exact), points) < 1e-9);
}

void ModelFitTest::recoversASphereAndACylinder()
{
    ModelFitOptions exact;
    exact.regularisation = 1e-9;
    for (bool isCylinder : {false, true}) {
        const std::vector<OrientedPoint> points = roundSamples(0.4, isCylinder, 400);
        QVERIFY(worstDistance(fitAll(points, 2, exact), points) < 1e-6);
        const ImplicitPolynomial byDefault = fitAll(points, 2, {});
        QVERIFY2(worstDistance(byDefault, points) < 4e-3,
                 qPrintable(QString::number(worstDistance(byDefault, points))));
        // A plane cannot do it: the test would notice a fit that ignores its points.
        QVERIFY(worstDistance(fitAll(points, 1, {}), points) > 0.05);
    }
}

void ModelFitTest::gradientPointsAlongTheNormals()
{
    const std::vector<OrientedPoint> points = roundSamples(0.4, false, 400);
    for (int degree = 2; degree <= maxPolynomialDegree; ++degree) {
        const ImplicitPolynomial model = fitAll(points, degree, {});
        for (const OrientedPoint &p : points) {
            Vec3 normal;
            model.signedDistance(p.point, &normal);
            QVERIFY(normal.dot(p.normal) > 0.95);
        }
    }
}

void ModelFitTest::minimisesTheObjective_data()
{
    QTest::addColumn<int>("degree");
    QTest::addColumn<double>("mu");
    QTest::addColumn<double>("lambda");
    for (int degree = 1; degree <= maxPolynomialDegree; ++degree) {
        QTest::addRow("degree %d, thesis", degree) << degree << 0.1 << 1.0;
        QTest::addRow("degree %d, other", degree) << degree << 3.0 << 0.05;
    }
}

void ModelFitTest::minimisesTheObjective()
{
    QFETCH(int, degree);
    QFETCH(double, mu);
    QFETCH(double, lambda);
    Random random(7);
    std::vector<OrientedPoint> points = roundSamples(0.4, false, 120);
    for (OrientedPoint &p : points) { // away from any exact fit
        p.point += 0.02 * Vec3(random.normal(), random.normal(), random.normal());
        p.normal = (p.normal + 0.2 * Vec3(random.normal(), random.normal(), random.normal())).normalized();
    }
    ModelFitOptions options;
    options.alignment = mu;
    options.regularisation = lambda;
    const Objective objective(points, degree, mu, lambda);
    const Eigen::VectorXd hat = objective.hatOf(fitAll(points, degree, options));
    const Eigen::VectorXd best = objective.rows.colPivHouseholderQr().solve(objective.target);
    QVERIFY2((hat - best).norm() < 1e-7 * best.norm(), qPrintable(QString::number((hat - best).norm())));
    for (Eigen::Index k = 0; k < hat.size(); ++k)
        for (double step : {-1e-3, 1e-3}) {
            Eigen::VectorXd other = hat;
            other[k] += step;
            QVERIFY(objective(other) > objective(hat));
        }
}

void ModelFitTest::movesWithItsPoints()
{
    const std::vector<OrientedPoint> points = roundSamples(0.4, true, 150);
    const Vec3 shift(3.0, -2.0, 5.0);
    std::vector<OrientedPoint> shifted = points;
    for (OrientedPoint &p : shifted)
        p.point += shift;
    for (int degree = 1; degree <= maxPolynomialDegree; ++degree) {
        const ImplicitPolynomial here = fitAll(points, degree, {}), there = fitAll(shifted, degree, {});
        for (const Vec3 &p : {Vec3(0.4, 0, 0), Vec3(0.1, 0.2, 0.3), Vec3(-0.3, 0.5, 0)})
            QVERIFY(std::abs(here.value(p) - there.value(p + shift)) < 1e-8);
    }
}

void ModelFitTest::boostScalesBothRegularisers()
{
    const std::vector<OrientedPoint> points = roundSamples(0.4, false, 60);
    ModelFitOptions boosted, scaled;
    boosted.boost = 10.0;
    scaled.alignment *= 10.0;
    scaled.regularisation *= 10.0;
    const Eigen::VectorXd a = fitAll(points, 4, boosted).theta, b = fitAll(points, 4, scaled).theta;
    QVERIFY((a - b).cwiseAbs().maxCoeff() <= 1e-12 * b.cwiseAbs().maxCoeff());
    QVERIFY((a - fitAll(points, 4, {}).theta).norm() > 1e-3 * b.norm());
}

void ModelFitTest::seesOnlyItsSubset()
{
    std::vector<OrientedPoint> points = roundSamples(0.4, false, 60);
    std::vector<int> even;
    for (int i = 0; i < 60; i += 2)
        even.push_back(i);
    const ImplicitPolynomial before = fitPolynomial(points, even, 3, {});
    for (int i = 1; i < 60; i += 2)
        points[std::size_t(i)] = {{9, 9, 9}, {0, 0, 1}};
    const ImplicitPolynomial after = fitPolynomial(points, even, 3, {});
    QVERIFY(before.theta == after.theta);
    QVERIFY(before.origin == after.origin);
}

void ModelFitTest::fewPointsGiveAPlaneThroughThem()
{
    const Vec3 normal = Vec3(2, 1, 2) / 3.0;
    for (int count : {1, 2, 3, 4, 6})
        for (int degree = 1; degree <= maxPolynomialDegree; ++degree) {
            const std::vector<OrientedPoint> points = planeSamples(normal, 0.05, count);
            const ImplicitPolynomial model = fitAll(points, degree, {});
            QVERIFY(model.theta.allFinite());
            for (const OrientedPoint &p : points) {
                Vec3 gradient;
                const double distance = model.signedDistance(p.point, &gradient);
                QVERIFY2(
                    std::abs(distance) < 0.05,
                    qPrintable(QString("%1 points, degree %2: %3").arg(count).arg(degree).arg(distance)));
                QVERIFY(gradient.dot(normal) > 0.0);
            }
        }
}

void ModelFitTest::pointsInACoordinatePlaneGiveThatPlane()
{
    const std::vector<OrientedPoint> points = planeSamples(Vec3::UnitZ(), 0.25, 100);
    for (int degree = 1; degree <= maxPolynomialDegree; ++degree) {
        const ImplicitPolynomial model = fitAll(points, degree, {});
        QVERIFY(model.theta.allFinite());
        QVERIFY(worstDistance(model, points) < 1e-6);
        Vec3 normal;
        QVERIFY(std::abs(model.signedDistance({0.0, 0.0, 0.26}, &normal) - 0.01) < 1e-3);
        QVERIFY(normal.z() > 0.99);
    }
}

QTEST_APPLESS_MAIN(ModelFitTest)
#include "model_fit_test.moc"
