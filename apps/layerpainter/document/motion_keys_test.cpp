#include "layerpainter/document/motion_keys.h"

#include "painting/testing/sample_painting.h"

#include <QtTest>

using namespace ductus;

class MotionKeysTest : public QObject
{
    Q_OBJECT
private slots:
    void theFirstKeyKeepsTheBeginning();
    void aKeyReplacesTheOneThatIsThere();
    void keysAreTakenAway();
    void actionsSetThem();

private:
    static Placement at(double x)
    {
        Placement placement;
        placement.translation = Vec3(x, 0, 0);
        return placement;
    }
};

void MotionKeysTest::theFirstKeyKeepsTheBeginning()
{
    const PlacementKeys keys = withKey({}, 2, at(4));
    QCOMPARE(keys.size(), 2u);
    QCOMPARE(keys[0].timeSeconds, 0.0);
    QVERIFY(keys[0].placement == Placement());
    QCOMPARE(placementAt(keys, 1).translation.x(), 2.0);
    QCOMPARE(withKey({}, 0, at(4)).size(), 1u);
}

void MotionKeysTest::aKeyReplacesTheOneThatIsThere()
{
    PlacementKeys keys{{0, at(0), KeyInterpolation::Linear}, {1, at(1), KeyInterpolation::Hold}};
    keys = withKey(keys, 1 + sameKeySeconds / 2, at(7));
    QCOMPARE(keys.size(), 2u);
    QCOMPARE(keys[1].timeSeconds, 1.0);
    QCOMPARE(keys[1].placement.translation.x(), 7.0);
    QVERIFY(keys[1].interpolation == KeyInterpolation::Hold);
    keys = withKey(keys, 0.5, at(3));
    QCOMPARE(keys.size(), 3u);
    QCOMPARE(keys[1].timeSeconds, 0.5);
}

void MotionKeysTest::keysAreTakenAway()
{
    const PlacementKeys keys{{0, at(0), {}}, {1, at(1), {}}};
    QVERIFY(hasKeyAt(keys, 1));
    QVERIFY(!hasKeyAt(keys, 0.5));
    QCOMPARE(withoutKey(keys, 1).size(), 1u);
    QCOMPARE(withoutKey(keys, 0.5).size(), 2u);
}

void MotionKeysTest::actionsSetThem()
{
    const Painting painting = samplePainting(3);
    const MovedThing thing = painting.stacks[1].substrate->id;
    const auto done = performed(painting, settingKeys(thing, withKey({}, 1, at(2))));
    QVERIFY(done.ok());
    QCOMPARE(keysOf(done->painting, thing)->size(), 2u);
    QCOMPARE(nameOf(done->painting, thing), painting.stacks[1].substrate->name);
    QCOMPARE(elementsOf(done->painting, thing, 0).size(), 5u);
    QVERIFY(!keysOf(painting, MovedThing(LayerId{9999})));
}

QTEST_GUILESS_MAIN(MotionKeysTest)
#include "motion_keys_test.moc"
