#include "surfacing/proxy/hermite_field.h"

namespace ductus {

HermiteField::HermiteField(const std::vector<Vec3> &centres, const Eigen::VectorXd &a, const Eigen::VectorXd &c,
                           const Eigen::Vector4d &b)
    : mB(b)
{
    const Eigen::Index n = Eigen::Index(centres.size());
    mX.resize(n);
    mY.resize(n);
    mZ.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        mX[i] = centres[std::size_t(i)].x();
        mY[i] = centres[std::size_t(i)].y();
        mZ[i] = centres[std::size_t(i)].z();
    }
    mA = a.array();
    mCx = 3.0 * c.segment(0, n).array();
    mCy = 3.0 * c.segment(n, n).array();
    mCz = 3.0 * c.segment(2 * n, n).array();
}

double HermiteField::value(const Vec3 &x) const
{
    // Fixed-size blocks keep the temporaries in registers and first-level cache.
    constexpr Eigen::Index block = 64;
    double sum = mB[0] + mB[1] * x.x() + mB[2] * x.y() + mB[3] * x.z();
    for (Eigen::Index i = 0; i < mX.size(); i += block) {
        const Eigen::Index n = std::min(block, mX.size() - i);
        Eigen::Array<double, Eigen::Dynamic, 1, 0, block, 1> dx(n), dy(n), dz(n), rr(n);
        dx = x.x() - mX.segment(i, n);
        dy = x.y() - mY.segment(i, n);
        dz = x.z() - mZ.segment(i, n);
        rr = dx * dx + dy * dy + dz * dz;
        sum += (rr.sqrt() * (mA.segment(i, n) * rr - mCx.segment(i, n) * dx - mCy.segment(i, n) * dy -
                             mCz.segment(i, n) * dz))
                   .sum();
    }
    return sum;
}

double HermiteField::valueAndGradient(const Vec3 &x, Vec3 &gradient) const
{
    double sum = mB[0] + mB[1] * x.x() + mB[2] * x.y() + mB[3] * x.z();
    gradient = mB.tail<3>();
    for (Eigen::Index i = 0; i < mX.size(); ++i) {
        const Vec3 d(x.x() - mX[i], x.y() - mY[i], x.z() - mZ[i]);
        const Vec3 c(mCx[i], mCy[i], mCz[i]); // three times c_i
        const double r = d.norm();
        const double cd = c.dot(d);
        sum += r * (mA[i] * r * r - cd);
        gradient += 3.0 * mA[i] * r * d - r * c;
        if (r > 1e-12)
            gradient -= cd / r * d;
    }
    return sum;
}

HermiteField HermiteField::negated() const
{
    HermiteField field = *this;
    for (Eigen::ArrayXd *weights : {&field.mA, &field.mCx, &field.mCy, &field.mCz})
        *weights = -*weights;
    field.mB = -field.mB;
    return field;
}

} // namespace ductus
