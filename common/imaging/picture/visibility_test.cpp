#include "imaging/picture/visibility.h"

#include "base/random.h"

#include <QtTest>
#include <cmath>

using namespace ductus;
using namespace ductus::picture;

namespace {

Vec3 randomPoint(Random &random, double size)
{
    return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

double distanceToSegment(const Vec3 &p, const Vec3 &a, const Vec3 &b)
{
    const double squared = (b - a).squaredNorm();
    const double t = squared > 0.0 ? std::clamp((p - a).dot(b - a) / squared, 0.0, 1.0) : 0.0;
    return (p - a - t * (b - a)).norm();
}

StageTriangle triangleOf(const Vec3 &a, const Vec3 &b, const Vec3 &c)
{
    StageTriangle triangle;
    triangle.corners = {a, b, c};
    triangle.faceNormal = (b - a).cross(c - a).normalized();
    triangle.normals.fill(triangle.faceNormal);
    triangle.albedo.fill(Vec3::Constant(0.5));
    return triangle;
}

PictureOptions smallOptions()
{
    PictureOptions options;
    options.width = 70; // not a multiple of the tiles
    options.height = 50;
    return options;
}

} // namespace

class VisibilityTest : public QObject
{
    Q_OBJECT
private slots:
    void tubesAreHitWhereSteppingAlongTheRayHitsThem();
    void samplesSeeTheNearestTriangle();
    void sharedEdgesLoseAndDoubleNoSample();
};

void VisibilityTest::tubesAreHitWhereSteppingAlongTheRayHitsThem()
{
    Random random(3);
    int hits = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const Vec3 a = Vec3(0, 0, 3) + randomPoint(random, 0.7);
        const Vec3 b = trial % 10 == 0 ? a : Vec3(Vec3(0, 0, 3) + randomPoint(random, 0.7));
        const double radius = random.uniform(0.02, 0.4);
        const Vec3 direction(random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4), 1.0);
        // Safe steps along the ray: each as long as the way to the tube.
        double depth = 0.0;
        const double speed = direction.norm();
        bool expected = false;
        for (int step = 0; step < 4000 && depth < 6.0; ++step) {
            const double gap = distanceToSegment(depth * direction, a, b) - radius;
            if (gap < 1e-9) {
                expected = true;
                break;
            }
            depth += gap / speed;
        }
        TubeHit hit;
        const bool found = hitTube(a, b, radius, direction, hit);
        if (found != expected) // only rays that just touch may be seen either way
            QVERIFY(std::abs(distanceToSegment(depth * direction, a, b) - radius) < 1e-6);
        if (found && expected) {
            ++hits;
            QVERIFY(std::abs(hit.depth - depth) < 1e-4);
            QVERIFY(std::abs(hit.normal.norm() - 1.0) < 1e-9);
            const Vec3 outside = hit.depth * direction + 1e-3 * hit.normal;
            QVERIFY(std::abs(distanceToSegment(outside, a, b) - radius - 1e-3) < 1e-6);
        }
    }
    QVERIFY2(hits > 100 && hits < 1700, qPrintable(QString::number(hits)));
}

void VisibilityTest::samplesSeeTheNearestTriangle()
{
    Random random(8);
    Stage stage;
    for (int i = 0; i < 60; ++i)
        stage.triangles.push_back(
            triangleOf(randomPoint(random, 0.3), randomPoint(random, 0.3), randomPoint(random, 0.3)));
    const PictureOptions options = smallOptions();
    const Camera camera = framedCamera(stage, options);
    const Visibility visibility(stage, camera, options.width, options.height, options.supersampling);
    QCOMPARE(visibility.tileColumns(), 3);
    QCOMPARE(visibility.tileRows(), 2);
    int seen = 0, differences = 0;
    std::vector<Sample> samples;
    for (int row = 0; row < 2; ++row) {
        for (int column = 0; column < 3; ++column) {
            visibility.traceTile(column, row, samples);
            const int side = visibility.tileSamples();
            for (int i = 0; i < side * side; ++i) {
                const double x = column * side + i % side + 0.5, y = row * side + i / side + 0.5;
                // Brute force: the ray against every triangle.
                const Vec3 ray = camera.ray(x, y);
                int nearest = -1;
                double best = 1e9;
                Vec3 weights = Vec3::Zero();
                for (int t = 0; t < int(stage.triangles.size()); ++t) {
                    Eigen::Matrix3d corners;
                    for (int k = 0; k < 3; ++k)
                        corners.col(k) =
                            camera.toEye(stage.triangles[std::size_t(t)].corners[std::size_t(k)]);
                    const Vec3 w = corners.inverse() * ray; // ray * depth = corners * weights
                    const double depth = 1.0 / w.sum();
                    if (w.minCoeff() >= 0.0 && depth < best) {
                        best = depth;
                        nearest = t;
                        weights = w / w.sum();
                    }
                }
                const Sample &sample = samples[std::size_t(i)];
                if (sample.triangle != nearest) {
                    ++differences;
                    continue;
                }
                if (nearest < 0)
                    continue;
                ++seen;
                QVERIFY(std::abs(double(sample.surfaceDepth) - best) < 1e-5);
                QVERIFY((visibility.barycentric(nearest, x, y) - weights).norm() < 1e-6);
            }
        }
    }
    QVERIFY(seen > 1000);
    QVERIFY2(differences <= 2, qPrintable(QString::number(differences))); // where triangles cut each other
}

void VisibilityTest::sharedEdgesLoseAndDoubleNoSample()
{
    // A fan around a corner that sits exactly on a sample, and edges along rows of samples.
    Stage stage;
    const int count = 16;
    for (int i = 0; i < count; ++i) {
        const auto at = [&](int k) {
            return Vec3(0.4 * std::cos(k % count * M_PI / 8), 0.4 * std::sin(k % count * M_PI / 8), 0.0);
        };
        stage.triangles.push_back(triangleOf(Vec3::Zero(), at(i), at(i + 1)));
    }
    PictureOptions options = smallOptions();
    options.azimuthDegrees = options.elevationDegrees = 0.0;
    Camera camera = framedCamera(stage, options);
    camera.centreX = std::floor(camera.centreX) + 0.5;
    camera.centreY = std::floor(camera.centreY) + 0.5;
    std::vector<Sample> all, single;
    const Visibility whole(stage, camera, options.width, options.height, options.supersampling);
    for (int row = 0; row < 2; ++row) {
        for (int column = 0; column < 3; ++column) {
            whole.traceTile(column, row, all);
            std::vector<int> owners(all.size(), 0);
            for (const StageTriangle &triangle : stage.triangles) {
                Stage one;
                one.triangles = {triangle};
                const Visibility alone(one, camera, options.width, options.height, options.supersampling);
                alone.traceTile(column, row, single);
                for (std::size_t i = 0; i < single.size(); ++i)
                    owners[i] += single[i].triangle >= 0 ? 1 : 0;
            }
            for (std::size_t i = 0; i < owners.size(); ++i) {
                QCOMPARE(owners[i] > 0, all[i].triangle >= 0);
                QVERIFY(owners[i] <= 1);
                // Inside the fan nothing is missing.
                const int side = whole.tileSamples();
                const double x = column * side + double(i % std::size_t(side)) + 0.5 - camera.centreX;
                const double y = row * side + double(i / std::size_t(side)) + 0.5 - camera.centreY;
                const double radius = std::hypot(x, y) / camera.focalSamples * camera.eyeInStage.z();
                if (radius < 0.39)
                    QVERIFY2(owners[i] == 1, qPrintable(QString("%1 at %2 %3").arg(owners[i]).arg(x).arg(y)));
            }
        }
    }
}

QTEST_APPLESS_MAIN(VisibilityTest)
#include "visibility_test.moc"
