#include "surfacing/proxy/rung_candidates.h"

#include "geometry/convex_hull.h"
#include "strokes/resample.h"
#include "support/sample_sketches.h"
#include "support/sketch_synthesis.h"
#include "surfacing/sketch/unit_frame.h"

#include <QtTest>
#include <algorithm>

using namespace ductus;

namespace {

StrokeSet sampleInUnitFrame(const std::string &id)
{
    for (const SampleSketch &sample : sampleSketches())
        if (sample.id == id) {
            const StrokeSet set = synthesizeSketch(sample.makeSolid(), sample.options).strokes;
            return inUnitFrame(set, unitFrameOf(set));
        }
    throw std::runtime_error("no sample " + id);
}

// Share of the vertices that lie more than 1.5 % of the diagonal outside the hull of the strokes.
double shareOutsideHull(const TriangleMesh &mesh, const StrokeSet &strokes)
{
    TriangleMesh hull;
    for (const Stroke &stroke : strokes.strokes)
        for (const Vec3 &p : resampled(stroke.points, 0.01))
            hull.vertices.push_back(p);
    hull.triangles = convexHull(hull.vertices);
    const auto isOutside = [&](const Vec3 &p) {
        for (int t = 0; t < hull.triangleCount(); ++t)
            if (hull.faceNormal(t).dot(p - hull.centroid(t)) > 0.015)
                return true;
        return false;
    };
    return double(std::count_if(mesh.vertices.begin(), mesh.vertices.end(), isOutside)) / mesh.vertexCount();
}

Vec3 saddlePoint(double u, double v)
{
    return {0.8 * u, 0.2 * (u * u - v * v), 0.6 * v};
}

StrokeSet saddleNet()
{
    StrokeSet strokes;
    for (int i = 0; i <= 6; ++i) {
        Stroke along, across;
        for (int j = 0; j <= 60; ++j) {
            along.points.push_back(saddlePoint(i / 6.0 - 0.5, j / 60.0 - 0.5));
            across.points.push_back(saddlePoint(j / 60.0 - 0.5, i / 6.0 - 0.5));
        }
        strokes.strokes.push_back(along);
        strokes.strokes.push_back(across);
    }
    return strokes;
}

ProxyGround sheetGround(const StrokeSet &strokes)
{
    const ProxyOptions options;
    Result<Wrap> wrap = wrapStrokes(strokes.allPoints(), options.wrap, {});
    if (!wrap)
        throw std::runtime_error(wrap.error().message());
    return groundOn(std::move(*wrap), strokes, strokes.allPoints(), true, options);
}

} // namespace

class RungsTest : public QObject
{
    Q_OBJECT

private slots:
    // Its wrap falls in through the sole, which nobody drew: without looser ones the field swells around it.
    void ironDoesNotSwell()
    {
        const StrokeSet strokes = sampleInUnitFrame("iron");
        ProxyOptions options;
        options.targetVertices = 4000;
        const Result<Proxy> proxy = makeProxy(strokes, options, {});
        QVERIFY2(proxy, proxy ? "" : proxy.error().message().c_str());
        QCOMPARE(int(proxy->kind), int(ProxyKind::Variational));
        QVERIFY(shareOutsideHull(proxy->mesh, strokes) < 0.02);

        options.disorder.looserWraps = 0;
        const Result<Proxy> swollen = makeProxy(strokes, options, {});
        QVERIFY(swollen);
        QVERIFY(swollen->alpha < proxy->alpha);
        QVERIFY(shareOutsideHull(swollen->mesh, strokes) > 0.1);
    }

    void soundSolidsAreInOrder()
    {
        const StrokeSet strokes = sampleInUnitFrame("bevelled-box");
        std::vector<Vec3> drawn;
        for (const Stroke &stroke : strokes.strokes)
            for (const Vec3 &p : resampled(stroke.points, 0.008))
                drawn.push_back(p);
        const ProxyOptions options;
        Result<Wrap> wrap = wrapStrokes(drawn, options.wrap, {});
        QVERIFY(wrap && !wrap->isShell);
        const ProxyGround ground = groundOn(std::move(*wrap), strokes, drawn, false, options);
        const Result<ProxyRung> rung = makeRung(ProxyKind::Variational, ground, 1e-4, options, {});
        QVERIFY(rung);
        QVERIFY(rung->disorder < 0.01);
    }

    // One field, but taken for a sheet: what ends with the neighbourhood is no fault there.
    void sheetsHaveNoDisorder()
    {
        const Result<ProxyRung> rung =
            makeRung(ProxyKind::Variational, sheetGround(saddleNet()), 1e-4, ProxyOptions(), {});
        QVERIFY(rung);
        QCOMPARE(rung->disorder, 0.0);
    }

    // An end that was drawn again, by strokes that waver through the first ones: two walls, with tunnels.
    void sheetDrawnTwiceIsOneSheet()
    {
        StrokeSet strokes = saddleNet();
        for (int i = 0; i < 3; ++i) {
            Stroke again;
            for (int j = 0; j <= 60; ++j)
                again.points.push_back(saddlePoint(0.5 - 0.07 * i, j / 60.0 - 0.5) +
                                       Vec3(0, -0.03 * std::cos(0.21 * j), 0));
            strokes.strokes.push_back(again);
        }
        const ProxyGround ground = sheetGround(strokes);
        const double lambda = 1e-4;
        const Result<ProxyRung> plain = makeRung(ProxyKind::Variational, ground, lambda, ProxyOptions(), {});
        QVERIFY(plain);
        QVERIFY(plain->disorder > 0.0);
        const RungCandidate calm =
            calmest(ProxyKind::Variational, ground, strokes, strokes.allPoints(), lambda, ProxyOptions(), {});
        QVERIFY(calm.rung);
        QVERIFY(calm.lambda > lambda);
        QCOMPARE(calm.rung->disorder, 0.0);
        ProxyOptions options;
        options.disorder.smoothings.clear();
        const RungCandidate rough =
            calmest(ProxyKind::Variational, ground, strokes, strokes.allPoints(), lambda, options, {});
        QVERIFY(rough.rung && rough.rung->disorder > 0.0);
    }
};

QTEST_GUILESS_MAIN(RungsTest)
#include "rungs_test.moc"
