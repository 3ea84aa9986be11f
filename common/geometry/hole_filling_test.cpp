#include "geometry/hole_filling.h"

#include "geometry/mesh_topology.h"
#include "support/mesh_zoo.h"

#include <QtTest>

using namespace ductus;

class HoleFillingTest : public QObject
{
    Q_OBJECT
private slots:
    void findsLoopsLongestFirst();
    void fillsOnlyShortLoopsAndStaysOriented();
};

namespace {

// A sphere without the triangles around the poles: a large hole above, a small one below.
TriangleMesh sphereWithTwoHoles()
{
    TriangleMesh sphere = zoo::icosphere(3);
    TriangleMesh open = sphere;
    open.triangles.clear();
    for (int t = 0; t < sphere.triangleCount(); ++t) {
        const double height = sphere.centroid(t).z();
        if (height < 0.7 && height > -0.92)
            open.triangles.push_back(sphere.triangles[std::size_t(t)]);
    }
    return compacted(open);
}

} // namespace

void HoleFillingTest::findsLoopsLongestFirst()
{
    const TriangleMesh open = sphereWithTwoHoles();
    const std::vector<std::vector<int>> loops = borderLoops(open);
    QCOMPARE(int(loops.size()), 2);
    QVERIFY(loopLength(open, loops[0]) > loopLength(open, loops[1]));
    QVERIFY(borderLoops(zoo::icosphere(2)).empty());
}

void HoleFillingTest::fillsOnlyShortLoopsAndStaysOriented()
{
    const TriangleMesh open = sphereWithTwoHoles();
    const std::vector<std::vector<int>> loops = borderLoops(open);
    const double between = 0.5 * (loopLength(open, loops[0]) + loopLength(open, loops[1]));
    const TriangleMesh one = withHolesFilled(open, between);
    QCOMPARE(int(borderLoops(one).size()), 1);
    const ManifoldReport closed = manifoldReport(withHolesFilled(open, 1e9));
    QVERIFY(closed.isClosed());
    QVERIFY(signedVolume(withHolesFilled(open, 1e9)) > 2.0);
}

QTEST_APPLESS_MAIN(HoleFillingTest)
#include "hole_filling_test.moc"
