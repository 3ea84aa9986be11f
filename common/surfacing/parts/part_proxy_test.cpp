#include "surfacing/parts/part_proxy.h"

#include "geometry/mesh_topology.h"
#include "support/box_sketch.h"
#include "surfacing/sketch/unit_frame.h"

#include <QtTest>
#include <algorithm>

using namespace ductus;

namespace {

// Two boxes, the second smaller and \a gap away, and a whisker near the second; in the unit frame.
StrokeSet twoBoxes(double gap)
{
    StrokeSet sketch = boxSketch({Vec3(0.4, 0.4, 0.4)});
    const std::size_t count = sketch.strokes.size();
    for (std::size_t s = 0; s < count; ++s) {
        Stroke stroke = sketch.strokes[s];
        for (Vec3 &p : stroke.points)
            p = 0.5 * p + Vec3(0.6 + gap, 0.0, 0.0);
        sketch.strokes.push_back(stroke);
    }
    Stroke whisker;
    whisker.points = {{0.6 + gap, 0.5, 0.0}, {0.6 + gap, 0.55, 0.0}};
    sketch.strokes.push_back(whisker);
    for (std::size_t s = 0; s < sketch.strokes.size(); ++s)
        sketch.strokes[s].id.value = int(s);
    return inUnitFrame(sketch, unitFrameOf(sketch));
}

ProxyOptions smallOptions()
{
    ProxyOptions options;
    options.targetVertices = 1500;
    options.fitPoints = 300;
    options.lambdaChoice.points = 120;
    options.cellsAlongDiagonal = 48;
    options.wrap.alphas = {1.0 / 4, 1.0 / 5, 1.0 / 6};
    return options;
}

} // namespace

class PartProxyTest : public QObject
{
    Q_OBJECT
private slots:
    void bodiesAreWhatTouches();
    void eachBodyHasItsOwnShell();
    void oneBodyIsMadeAsBefore();
};

void PartProxyTest::bodiesAreWhatTouches()
{
    const StrokeSet apart = twoBoxes(0.5);
    const std::vector<int> bodies = bodiesOf(apart, {});
    const std::size_t half = apart.strokes.size() / 2;
    for (std::size_t s = 0; s < bodies.size(); ++s)
        QCOMPARE(bodies[s], s < half ? 0 : 1); // the whisker goes with the nearest
    for (int body : bodiesOf(twoBoxes(0.02), {}))
        QCOMPARE(body, 0);
    StrokeSet ignored = apart;
    ignored.strokes[1].role = StrokeRole::Skeletal;
    QCOMPARE(bodiesOf(ignored, {})[1], -1);
}

void PartProxyTest::eachBodyHasItsOwnShell()
{
    const Result<Proxy> proxy = makePartProxy(twoBoxes(0.5), smallOptions(), {}, {});
    QVERIFY(proxy.ok());
    const ManifoldReport report = manifoldReport(proxy->mesh);
    QVERIFY(report.isClosed());
    QCOMPARE(report.components, 2);
    QVERIFY(signedVolume(proxy->mesh) > 0.0);
}

void PartProxyTest::oneBodyIsMadeAsBefore()
{
    const StrokeSet box = boxSketch({Vec3(0.5, 0.32, 0.4)});
    const StrokeSet unit = inUnitFrame(box, unitFrameOf(box));
    const Result<Proxy> parts = makePartProxy(unit, smallOptions(), {}, {});
    const Result<Proxy> plain = makeProxy(unit, smallOptions(), {});
    QVERIFY(parts.ok() && plain.ok());
    QVERIFY(parts->mesh.vertices == plain->mesh.vertices);
}

QTEST_APPLESS_MAIN(PartProxyTest)
#include "part_proxy_test.moc"
