#include "surfacing/proxy/local/local_fit.h"

#include "base/random.h"
#include "geometry/mesh_topology.h"
#include "geometry/nearest.h"
#include "surfacing/proxy/contour.h"
#include "surfacing/proxy/point_subset.h"
#include "surfacing/proxy/proxy_quality.h"

#include <QtTest>
#include <cmath>
#include <numbers>

using namespace ductus;

namespace {

// A surface known exactly: random points on it, and its distance and normal anywhere near.
struct Shape
{
    std::function<Vec3(Random &)> randomPoint;
    std::function<double(const Vec3 &)> distance; // signed
    std::function<bool(const Vec3 &)> isSmooth;   // far from every edge

    Vec3 normal(const Vec3 &x) const
    {
        Vec3 gradient;
        for (int k = 0; k < 3; ++k) {
            const Vec3 step = 1e-6 * Vec3::Unit(k);
            gradient[k] = distance(x + step) - distance(x - step);
        }
        return gradient.normalized();
    }
};

bool everywhere(const Vec3 &)
{
    return true;
}

Vec3 randomDirection(Random &random)
{
    return Vec3(random.normal(), random.normal(), random.normal()).normalized();
}

Shape sphere()
{
    const double radius = 0.28;
    return {[=](Random &random) { return Vec3(radius * randomDirection(random)); },
            [=](const Vec3 &x) { return x.norm() - radius; }, everywhere};
}

Shape torus()
{
    const double major = 0.25, minor = 0.09;
    return {[=](Random &random) {
                for (;;) { // even by rejection
                    const double u = random.uniform(0, 2 * std::numbers::pi),
                                 v = random.uniform(0, 2 * std::numbers::pi);
                    const double r = major + minor * std::cos(v);
                    if (random.uniform() * (major + minor) < r)
                        return Vec3(r * std::cos(u), minor * std::sin(v), r * std::sin(u));
                }
            },
            [=](const Vec3 &x) { return std::hypot(std::hypot(x.x(), x.z()) - major, x.y()) - minor; },
            everywhere};
}

double boxDistance(const Vec3 &x, const Vec3 &half)
{
    const Vec3 q = x.cwiseAbs() - half;
    return q.cwiseMax(0.0).norm() + std::min(0.0, q.maxCoeff());
}

// Boxes with sharp edges; one side of the cube's is 0.56, the plate is 0.024 thick.
Shape box(const Vec3 &half)
{
    return {[=](Random &random) {
                const Vec3 areas(half.y() * half.z(), half.z() * half.x(), half.x() * half.y());
                double pick = random.uniform() * areas.sum();
                int axis = 0;
                while (axis < 2 && pick >= areas[axis])
                    pick -= areas[axis++];
                Vec3 x;
                for (int k = 0; k < 3; ++k)
                    x[k] = random.uniform(-half[k], half[k]);
                x[axis] = random.uniform() < 0.5 ? -half[axis] : half[axis];
                return x;
            },
            [=](const Vec3 &x) { return boxDistance(x, half); },
            [=](const Vec3 &x) {
                const Vec3 toFace = (half - x.cwiseAbs()).cwiseAbs();
                int near = 0;
                for (int k = 0; k < 3; ++k)
                    near += toFace[k] < 0.04;
                return near < 2;
            }};
}

Shape shapeNamed(const QString &name)
{
    if (name == "sphere")
        return sphere();
    if (name == "torus")
        return torus();
    return name == "cube" ? box(Vec3::Constant(0.28)) : box(Vec3(0.4, 0.012, 0.28));
}

// About \a count points, none much nearer than the others.
std::vector<Vec3> spreadSamples(const Shape &shape, int count)
{
    Random random(5);
    std::vector<Vec3> candidates;
    for (int i = 0; i < 4 * count; ++i)
        candidates.push_back(shape.randomPoint(random));
    double spacing = 1.2 / std::sqrt(double(count));
    std::vector<Vec3> points;
    do
        points = spreadOut(candidates, spacing *= 0.93);
    while (int(points.size()) < count);
    points.resize(std::size_t(count)); // random order: thinned evenly
    return points;
}

struct Quality
{
    double medianDegrees = 0.0, p95Degrees = 0.0;
    int flipped = 0;
    double meanDistance = 0.0, maxDistance = 0.0; // of the zero set to the shape
    ManifoldReport manifold;
    int eulerNumber = 0;
};

double at(std::vector<double> values, double share)
{
    std::sort(values.begin(), values.end());
    return values[std::size_t(share * double(values.size() - 1))];
}

// The rough field the pipeline uses as well: a dense fit to a well-spread few.
Result<HermiteField> roughField(const std::vector<Vec3> &points, const Shape &shape)
{
    std::vector<Vec3> few;
    for (int i : farthestPoints(points, 300, 0.0))
        few.push_back(points[std::size_t(i)]);
    VariationalFitOptions options;
    options.lambda = 1e-4;
    const Result<VariationalFit> fit = fitVariational(few, {}, options, JobControl());
    if (!fit)
        return fit.error();
    double agreement = 0.0;
    for (std::size_t i = 0; i < few.size(); ++i)
        agreement += fit->normals[i].dot(shape.normal(few[i]));
    return agreement < 0.0 ? fit->field.negated() : fit->field;
}

Result<Quality> qualityOf(const std::vector<Vec3> &points, const Shape &shape, const LocalFit &fit)
{
    Quality quality;
    std::vector<double> degrees;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double cosine = fit.normals[i].dot(shape.normal(points[i]));
        quality.flipped += cosine < 0.0;
        if (shape.isSmooth(points[i]))
            degrees.push_back(std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi);
    }
    quality.medianDegrees = at(degrees, 0.5);
    quality.p95Degrees = at(degrees, 0.95);
    Box3 box = boundingBox(points);
    box.min.array() -= 0.05;
    box.max.array() += 0.05;
    Result<TriangleMesh> mesh = contourFromSeeds([&](const Vec3 &x) { return fit.field.value(x); }, points,
                                                 box, {1.0 / 96, 3'000'000, 2}, JobControl());
    if (!mesh)
        return mesh.error();
    *mesh = withoutStrayComponents(*mesh, points);
    for (const Vec3 &v : mesh->vertices) {
        const double distance = std::abs(shape.distance(v));
        quality.meanDistance += distance / double(mesh->vertexCount());
        quality.maxDistance = std::max(quality.maxDistance, distance);
    }
    quality.manifold = manifoldReport(*mesh);
    quality.eulerNumber = mesh->vertexCount() - int(MeshTopology(*mesh).edges.size()) + mesh->triangleCount();
    return quality;
}

} // namespace

class LocalFitTest : public QObject
{
    Q_OBJECT
private slots:
    void thousandsOfPointsWithoutNormals_data();
    void thousandsOfPointsWithoutNormals();
    void aRoughFieldTurnedOverTurnsAll();
    void strokesAreNoCurvesToTurnAbout();
    void sameAnswerEveryTime();
    void cancelled();
};

void LocalFitTest::thousandsOfPointsWithoutNormals_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("count");
    QTest::addColumn<double>("noise");
    QTest::addColumn<int>("eulerNumber");
    QTest::addColumn<double>("degrees"); // median; the 95th percentile may be three times that
    QTest::addColumn<double>("mean");    // distances, share of the diagonal
    QTest::addColumn<double>("max");
    QTest::newRow("sphere") << "sphere" << 5000 << 0.0 << 2 << 0.3 << 1e-4 << 1e-3;
    QTest::newRow("torus") << "torus" << 5000 << 0.0 << 0 << 1.0 << 1e-4 << 1e-3;
    QTest::newRow("cube") << "cube" << 5000 << 0.0 << 2 << 0.5 << 5e-4 << 0.01;
    QTest::newRow("plate") << "plate" << 5000 << 0.0 << 2 << 1.0 << 1e-3 << 0.01;
    QTest::newRow("noisy sphere") << "sphere" << 5000 << 0.002 << 2 << 3.0 << 8e-4 << 5e-3;
    QTest::newRow("noisy cube") << "cube" << 5000 << 0.002 << 2 << 4.0 << 1.5e-3 << 0.02;
    QTest::newRow("many: cube") << "cube" << 20000 << 0.0 << 2 << 0.3 << 3e-4 << 0.006;
    QTest::newRow("many: noisy torus") << "torus" << 20000 << 0.001 << 0 << 4.0 << 5e-4 << 3e-3;
}

void LocalFitTest::thousandsOfPointsWithoutNormals()
{
    QFETCH(QString, name);
    QFETCH(int, count);
    QFETCH(double, noise);
    QFETCH(int, eulerNumber);
    QFETCH(double, degrees);
    QFETCH(double, mean);
    QFETCH(double, max);
    const Shape shape = shapeNamed(name);
    std::vector<Vec3> points = spreadSamples(shape, count);
    Random random(9);
    for (Vec3 &p : points)
        for (int k = 0; k < 3; ++k)
            p[k] += noise * random.normal();
    const Result<HermiteField> rough = roughField(points, shape);
    QVERIFY2(rough.ok(), rough ? "" : rough.error().message().c_str());
    const Result<LocalFit> fit = fitLocally(points, *rough, {}, JobControl());
    QVERIFY2(fit.ok(), fit ? "" : fit.error().message().c_str());
    const Result<Quality> q = qualityOf(points, shape, *fit);
    QVERIFY2(q.ok(), q ? "" : q.error().message().c_str());
    const QString found = QString("normals %1 / %2 degrees, %3 flipped; distance %4 / %5; noise %6; chi %7")
                              .arg(q->medianDegrees)
                              .arg(q->p95Degrees)
                              .arg(q->flipped)
                              .arg(q->meanDistance)
                              .arg(q->maxDistance)
                              .arg(fit->noise)
                              .arg(q->eulerNumber);
    qInfo("%s", qPrintable(found));
    QVERIFY2(q->flipped == 0, qPrintable(found));
    QVERIFY2(q->medianDegrees <= degrees && q->p95Degrees <= 3.0 * degrees, qPrintable(found));
    QVERIFY2(q->meanDistance <= mean && q->maxDistance <= max, qPrintable(found));
    QVERIFY2(q->manifold.isClosed() && q->manifold.components == 1, qPrintable(found));
    QCOMPARE(q->eulerNumber, eulerNumber);
    if (noise > 0.0)
        QVERIFY2(fit->noise > 0.7 * noise && fit->noise < 1.5 * noise, qPrintable(found));
    QCOMPARE(fit->unfittedPatches, 0);
}

// The points cannot know which side is outside; the rough field decides, for all alike.
void LocalFitTest::aRoughFieldTurnedOverTurnsAll()
{
    const Shape shape = torus();
    const std::vector<Vec3> points = spreadSamples(shape, 1500);
    const Result<HermiteField> rough = roughField(points, shape);
    QVERIFY(rough.ok());
    const Result<LocalFit> out = fitLocally(points, *rough, {}, JobControl());
    const Result<LocalFit> in = fitLocally(points, rough->negated(), {}, JobControl());
    QVERIFY(out.ok() && in.ok());
    for (std::size_t i = 0; i < points.size(); ++i) {
        QVERIFY(out->normals[i].dot(shape.normal(points[i])) > 0.9);
        QVERIFY(in->normals[i].dot(shape.normal(points[i])) < -0.9);
    }
}

// Rings close along themselves and far from each other: a patch of near points alone would be a piece of one
// ring.
void LocalFitTest::strokesAreNoCurvesToTurnAbout()
{
    const Shape shape = sphere();
    std::vector<Vec3> points;
    for (int ring = 1; ring < 12; ++ring)
        for (int i = 0; i < 200; ++i) {
            const double u = std::numbers::pi * ring / 12, v = 2 * std::numbers::pi * i / 200;
            points.push_back(0.28 * Vec3(std::sin(u) * std::cos(v), std::cos(u), std::sin(u) * std::sin(v)));
        }
    const Result<HermiteField> rough = roughField(points, shape);
    QVERIFY(rough.ok());
    const Result<LocalFit> fit = fitLocally(spreadOut(points, 0.003), *rough, {}, JobControl());
    QVERIFY(fit.ok());
    const std::vector<Vec3> spread = spreadOut(points, 0.003);
    for (std::size_t i = 0; i < spread.size(); ++i)
        QVERIFY(fit->normals[i].dot(shape.normal(spread[i])) > std::cos(0.15));
    for (const Patch &patch : coverWithPatches(PointTree(spread), {})) {
        Box3 box;
        for (int i : patch.members)
            box.add(spread[std::size_t(i)]);
        QVERIFY(box.max.y() - box.min.y() > 0.01); // more than one ring
    }
}

void LocalFitTest::sameAnswerEveryTime()
{
    const Shape shape = box(Vec3::Constant(0.28));
    const std::vector<Vec3> points = spreadSamples(shape, 1200);
    const Result<HermiteField> rough = roughField(points, shape);
    QVERIFY(rough.ok());
    const Result<LocalFit> a = fitLocally(points, *rough, {}, JobControl());
    const Result<LocalFit> b = fitLocally(points, *rough, {}, JobControl());
    QVERIFY(a.ok() && b.ok());
    QVERIFY(a->normals == b->normals);
    for (const Vec3 &p : points)
        QCOMPARE(a->field.value(1.01 * p), b->field.value(1.01 * p));
}

void LocalFitTest::cancelled()
{
    const Shape shape = sphere();
    const std::vector<Vec3> points = spreadSamples(shape, 1200);
    const Result<HermiteField> rough = roughField(points, shape);
    QVERIFY(rough.ok());
    const std::atomic<bool> cancel = true;
    const Result<LocalFit> fit = fitLocally(points, *rough, {}, JobControl(&cancel, {}));
    QVERIFY(!fit.ok() && fit.error().isCancelled());
}

QTEST_APPLESS_MAIN(LocalFitTest)
#include "local_fit_test.moc"
