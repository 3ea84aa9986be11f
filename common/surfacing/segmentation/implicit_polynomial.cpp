#include "surfacing/segmentation/implicit_polynomial.h"

#include "base/assert.h"

#include <Eigen/Dense>
#include <array>
#include <cmath>

namespace ductus {

namespace {

struct Exponents
{
    std::array<std::array<int, 3>, maxMonomialCount> of;
};

constexpr Exponents makeExponents()
{
    Exponents e{};
    int k = 0;
    for (int degree = 0; degree <= maxPolynomialDegree; ++degree)
        for (int i = degree; i >= 0; --i)
            for (int j = degree - i; j >= 0; --j)
                e.of[std::size_t(k++)] = {i, j, degree - i - j};
    return e;
}

constexpr Exponents exponents = makeExponents();

// x^0 .. x^4 of each coordinate
struct Powers
{
    double of[3][maxPolynomialDegree + 1];

    explicit Powers(const Vec3 &p)
    {
        for (int k = 0; k < 3; ++k) {
            of[k][0] = 1.0;
            for (int d = 1; d <= maxPolynomialDegree; ++d)
                of[k][d] = of[k][d - 1] * p[k];
        }
    }
};

} // namespace

int monomialCount(int degree)
{
    DUCTUS_ASSERT(degree >= 0 && degree <= maxPolynomialDegree);
    return (degree + 1) * (degree + 2) * (degree + 3) / 6;
}

void evaluateMonomials(const Vec3 &p, int degree, double *values)
{
    const Powers powers(p);
    const int count = monomialCount(degree);
    for (int m = 0; m < count; ++m) {
        const auto &e = exponents.of[std::size_t(m)];
        values[m] = powers.of[0][e[0]] * powers.of[1][e[1]] * powers.of[2][e[2]];
    }
}

void evaluateMonomials(const Vec3 &p, int degree, double *values, double *dx, double *dy, double *dz)
{
    const Powers powers(p);
    const int count = monomialCount(degree);
    for (int m = 0; m < count; ++m) {
        const auto &e = exponents.of[std::size_t(m)];
        const double x = powers.of[0][e[0]], y = powers.of[1][e[1]], z = powers.of[2][e[2]];
        values[m] = x * y * z;
        dx[m] = e[0] ? e[0] * powers.of[0][e[0] - 1] * y * z : 0.0;
        dy[m] = e[1] ? e[1] * powers.of[1][e[1] - 1] * x * z : 0.0;
        dz[m] = e[2] ? e[2] * powers.of[2][e[2] - 1] * x * y : 0.0;
    }
}

double ImplicitPolynomial::value(const Vec3 &p) const
{
    double monomials[maxMonomialCount];
    evaluateMonomials(p - origin, degree, monomials);
    return Eigen::Map<const Eigen::VectorXd>(monomials, theta.size()).dot(theta);
}

double ImplicitPolynomial::valueAndGradient(const Vec3 &p, Vec3 &gradient) const
{
    double m[maxMonomialCount], dx[maxMonomialCount], dy[maxMonomialCount], dz[maxMonomialCount];
    evaluateMonomials(p - origin, degree, m, dx, dy, dz);
    const Eigen::Index n = theta.size();
    using Row = Eigen::Map<const Eigen::VectorXd>;
    gradient = {Row(dx, n).dot(theta), Row(dy, n).dot(theta), Row(dz, n).dot(theta)};
    return Row(m, n).dot(theta);
}

double ImplicitPolynomial::signedDistance(const Vec3 &p, Vec3 *unitGradient) const
{
    Vec3 gradient;
    const double f = valueAndGradient(p, gradient);
    const double length = std::max(gradient.norm(), 1e-9);
    if (unitGradient)
        *unitGradient = gradient / length;
    return f / length;
}

ImplicitPolynomial mirrored(const ImplicitPolynomial &model, const Vec3 &normal, double offset)
{
    // Mirroring is affine, so the mirrored polynomial has the same degree: interpolate it at enough points of a
    // small lattice around the mirrored origin instead of expanding products of linear forms.
    const auto mirror = [&](const Vec3 &p) -> Vec3 { return p - 2.0 * (normal.dot(p) - offset) * normal; };
    ImplicitPolynomial result = model;
    result.origin = mirror(model.origin);
    const int count = monomialCount(model.degree);
    Eigen::MatrixXd rows(125, count);
    Eigen::VectorXd values(125);
    std::array<double, maxMonomialCount> monomials;
    int row = 0;
    for (int i = -2; i <= 2; ++i)
        for (int j = -2; j <= 2; ++j)
            for (int k = -2; k <= 2; ++k, ++row) {
                const Vec3 local = 0.5 * Vec3(i, j, k);
                evaluateMonomials(local, model.degree, monomials.data());
                for (int m = 0; m < count; ++m)
                    rows(row, m) = monomials[std::size_t(m)];
                values[row] = model.value(mirror(result.origin + local));
            }
    result.theta = rows.householderQr().solve(values);
    return result;
}

} // namespace ductus
