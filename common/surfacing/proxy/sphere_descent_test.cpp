#include "surfacing/proxy/sphere_descent.h"

#include "base/random.h"

#include <Eigen/Dense>
#include <QtTest>
#include <numbers>

using namespace ductus;

namespace {

Eigen::MatrixXd randomEnergy(int n, std::uint64_t seed)
{
    Random random(seed);
    Eigen::MatrixXd A(3 * n, 3 * n);
    for (Eigen::Index i = 0; i < A.size(); ++i)
        A.data()[i] = random.normal();
    return A.transpose() * A + 0.1 * Eigen::MatrixXd::Identity(3 * n, 3 * n);
}

Eigen::VectorXd unitVectors(const std::vector<double> &angles) // two an unknown vector
{
    const Eigen::Index n = Eigen::Index(angles.size() / 2);
    Eigen::VectorXd g(3 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const double a = angles[std::size_t(2 * i)], b = angles[std::size_t(2 * i + 1)];
        g[i] = std::sin(a) * std::cos(b);
        g[n + i] = std::sin(a) * std::sin(b);
        g[2 * n + i] = std::cos(a);
    }
    return g;
}

Eigen::VectorXd randomStart(int n, Random &random)
{
    std::vector<double> angles;
    for (int i = 0; i < 2 * n; ++i)
        angles.push_back(random.uniform(0.0, 2.0 * std::numbers::pi));
    return unitVectors(angles);
}

Result<SphereMinimum> descend(const Eigen::MatrixXd &H, const Eigen::VectorXd &start,
                              SphereDescentOptions options = {})
{
    return minimiseOnSpheres([&](const Eigen::VectorXd &g) -> Eigen::VectorXd { return H * g; }, start,
                             options, {});
}

// The least energy on a grid of all six angles, then a pattern search down to 1e-6 of a radian.
double bruteForce(const Eigen::MatrixXd &H)
{
    constexpr int steps = 8;
    std::vector<double> angles(6), best(6);
    double energy = 1e300;
    for (int code = 0; code < steps * steps * steps * steps * steps * steps / 2; ++code) { // E(g) = E(-g)
        int rest = code;
        for (double &angle : angles) {
            angle =
                std::numbers::pi * (rest % steps + 0.5) / steps * (&angle - angles.data() & 1 ? 2.0 : 1.0);
            rest /= steps;
        }
        const Eigen::VectorXd g = unitVectors(angles);
        const double e = g.dot(H * g);
        if (e < energy) {
            energy = e;
            best = angles;
        }
    }
    for (double step = 0.3; step > 1e-6;) {
        bool improved = false;
        for (std::size_t k = 0; k < 6; ++k)
            for (double sign : {-1.0, 1.0}) {
                std::vector<double> trial = best;
                trial[k] += sign * step;
                const Eigen::VectorXd g = unitVectors(trial);
                if (const double e = g.dot(H * g); e < energy) {
                    energy = e;
                    best = trial;
                    improved = true;
                }
            }
        if (!improved)
            step *= 0.5;
    }
    return energy;
}

} // namespace

class SphereDescentTest : public QObject
{
    Q_OBJECT
private slots:
    void agreesWithBruteForceOnThreePoints();
    void endsAtAStationaryPoint();
    void uncoupledVectorsFindTheirLowestEigenvectors();
    void startAtTheMinimumStays();
    void cancelled();
};

void SphereDescentTest::agreesWithBruteForceOnThreePoints()
{
    for (std::uint64_t seed : {1, 2, 3}) {
        const Eigen::MatrixXd H = randomEnergy(3, seed);
        const double truth = bruteForce(H);
        Random random(seed + 10);
        double best = 1e300;
        SphereDescentOptions options;
        options.tolerance = 1e-10;
        for (int start = 0; start < 30; ++start) {
            const auto minimum = descend(H, randomStart(3, random), options);
            QVERIFY(minimum.ok());
            QVERIFY(minimum->energy > truth - 1e-6 * truth);
            best = std::min(best, minimum->energy);
        }
        QVERIFY2(best < truth + 1e-5 * truth, qPrintable(QString("%1 %2").arg(best).arg(truth)));
    }
}

void SphereDescentTest::endsAtAStationaryPoint()
{
    constexpr int n = 40;
    const Eigen::MatrixXd H = randomEnergy(n, 5);
    Random random(6);
    const Eigen::VectorXd start = randomStart(n, random);
    SphereDescentOptions options;
    options.maxIterations = 2000;
    options.tolerance = 1e-14;
    const auto minimum = descend(H, start, options);
    QVERIFY(minimum.ok());
    const Eigen::VectorXd &g = minimum->g;
    QVERIFY(std::abs(minimum->energy - g.dot(H * g)) < 1e-9 * minimum->energy);
    QVERIFY(minimum->energy < start.dot(H * start));
    QVERIFY(minimum->evaluations > 1);
    const Eigen::VectorXd gradient = 2.0 * H * g;
    for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::Vector3d gi(g[i], g[n + i], g[2 * n + i]);
        Eigen::Vector3d slope(gradient[i], gradient[n + i], gradient[2 * n + i]);
        QVERIFY(std::abs(gi.norm() - 1.0) < 1e-12);
        slope -= slope.dot(gi) * gi;
        QVERIFY2(slope.norm() < 1e-3 * gradient.norm(), qPrintable(QString::number(slope.norm())));
    }
}

void SphereDescentTest::uncoupledVectorsFindTheirLowestEigenvectors()
{
    constexpr int n = 10;
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(3 * n, 3 * n);
    double truth = 0.0;
    for (int i = 0; i < n; ++i) {
        const Eigen::MatrixXd block = randomEnergy(1, std::uint64_t(100 + i));
        for (int k = 0; k < 3; ++k)
            for (int l = 0; l < 3; ++l)
                H(k * n + i, l * n + i) = block(k, l);
        truth += Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(block).eigenvalues()[0];
    }
    Random random(1);
    SphereDescentOptions options;
    options.maxIterations = 1000;
    options.tolerance = 1e-13;
    const auto minimum = descend(H, randomStart(n, random), options);
    QVERIFY(minimum.ok());
    QVERIFY2(std::abs(minimum->energy - truth) < 1e-6 * truth,
             qPrintable(QString("%1 %2").arg(minimum->energy).arg(truth)));
}

void SphereDescentTest::startAtTheMinimumStays()
{
    Eigen::MatrixXd H = Eigen::MatrixXd::Identity(6, 6) * 4.0;
    H(0, 0) = H(1, 1) = 1.0; // x of both vectors is cheap
    Eigen::VectorXd start = Eigen::VectorXd::Zero(6);
    start[0] = 1.0;
    start[1] = -1.0;
    const auto minimum = descend(H, start);
    QVERIFY(minimum.ok());
    QCOMPARE(minimum->energy, 2.0);
    QVERIFY(minimum->g == start);
}

void SphereDescentTest::cancelled()
{
    const std::atomic<bool> cancel = true;
    Random random(1);
    const Eigen::MatrixXd H = randomEnergy(5, 1);
    const auto minimum = minimiseOnSpheres([&](const Eigen::VectorXd &g) -> Eigen::VectorXd { return H * g; },
                                           randomStart(5, random), {}, JobControl(&cancel, {}));
    QVERIFY(!minimum.ok());
    QVERIFY(minimum.error().isCancelled());
}

QTEST_APPLESS_MAIN(SphereDescentTest)
#include "sphere_descent_test.moc"
