#include "surfacing/proxy/hermite_field.h"

#include "base/random.h"

#include <QtTest>

using namespace ductus;

namespace {

Vec3 randomVec(Random &random)
{
    const double x = random.uniform(-1.0, 1.0), y = random.uniform(-1.0, 1.0);
    return {x, y, random.uniform(-1.0, 1.0)};
}

struct Terms
{
    std::vector<Vec3> centres;
    Eigen::VectorXd a, c;
    Eigen::Vector4d b;

    Terms(int n, std::uint64_t seed)
    {
        Random random(seed);
        a.resize(n);
        c.resize(3 * n);
        for (int i = 0; i < n; ++i) {
            centres.push_back(randomVec(random));
            a[i] = random.uniform(-1.0, 1.0);
            for (int k = 0; k < 3; ++k)
                c[k * n + i] = random.uniform(-1.0, 1.0);
        }
        b << 0.3, -0.2, 0.5, 0.1;
    }
    HermiteField field() const { return {centres, a, c, b}; }
    double byDefinition(const Vec3 &x) const
    {
        const int n = int(centres.size());
        double sum = b[0] + b.tail<3>().dot(x);
        for (int i = 0; i < n; ++i) {
            const Vec3 d = x - centres[i], ci(c[i], c[n + i], c[2 * n + i]);
            sum += a[i] * std::pow(d.norm(), 3) - 3.0 * d.norm() * ci.dot(d);
        }
        return sum;
    }
};

} // namespace

class HermiteFieldTest : public QObject
{
    Q_OBJECT
private slots:
    void valueIsTheFormula_data();
    void valueIsTheFormula();
    void gradientAgreesWithDifferences();
    void smoothAtItsCentres();
    void withoutCentresItIsLinear();
};

void HermiteFieldTest::valueIsTheFormula_data()
{
    QTest::addColumn<int>("count");
    for (int count : {1, 5, 63, 64, 65, 200}) // around the size of the blocks it sums in
        QTest::addRow("%d centres", count) << count;
}

void HermiteFieldTest::valueIsTheFormula()
{
    QFETCH(int, count);
    const Terms terms(count, 3);
    const HermiteField field = terms.field();
    Random random(7);
    for (int i = 0; i < 30; ++i) {
        const Vec3 x = randomVec(random);
        Vec3 gradient;
        QVERIFY(std::abs(field.value(x) - terms.byDefinition(x)) < 1e-11 * count);
        QVERIFY(std::abs(field.valueAndGradient(x, gradient) - field.value(x)) < 1e-11 * count);
    }
}

void HermiteFieldTest::gradientAgreesWithDifferences()
{
    const HermiteField field = Terms(40, 5).field();
    Random random(2);
    constexpr double h = 1e-5;
    for (int i = 0; i < 50; ++i) {
        const Vec3 x = randomVec(random);
        Vec3 gradient;
        field.valueAndGradient(x, gradient);
        for (int k = 0; k < 3; ++k) {
            const double slope =
                (field.value(x + h * Vec3::Unit(k)) - field.value(x - h * Vec3::Unit(k))) / (2 * h);
            QVERIFY(std::abs(slope - gradient[k]) < 1e-6);
        }
    }
}

void HermiteFieldTest::smoothAtItsCentres()
{
    const Terms terms(20, 6);
    const HermiteField field = terms.field();
    for (const Vec3 &p : terms.centres) {
        Vec3 at, beside;
        const double value = field.valueAndGradient(p, at);
        QVERIFY(std::isfinite(value) && at.allFinite());
        field.valueAndGradient(p + Vec3(1e-7, -1e-7, 1e-7), beside);
        QVERIFY((at - beside).norm() < 1e-4);
    }
}

void HermiteFieldTest::withoutCentresItIsLinear()
{
    const HermiteField field({}, Eigen::VectorXd(), Eigen::VectorXd(), {1.0, 2.0, -3.0, 4.0});
    Vec3 gradient;
    QCOMPARE(field.valueAndGradient({1, 1, 1}, gradient), 4.0);
    QCOMPARE(gradient, Vec3(2, -3, 4));
    QCOMPARE(field.value({0, 0, 2}), 9.0);
}

QTEST_APPLESS_MAIN(HermiteFieldTest)
#include "hermite_field_test.moc"
