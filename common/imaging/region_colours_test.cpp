#include "imaging/region_colours.h"

#include "base/random.h"

#include <QtTest>
#include <set>

using namespace ductus;

class RegionColoursTest : public QObject
{
    Q_OBJECT
private slots:
    void coloursStayApartForEveryone();
    void distanceKnowsPublishedValues();
    void neighboursNeverShareAColour();
    void fewRegionsGetDifferentColours();
    void orderOfNeighboursDoesNotMatter();
    void crowdedAndWrongInput();
};

void RegionColoursTest::coloursStayApartForEveryone()
{
    for (int missing = -1; missing < 3; ++missing) {
        const auto seen = [missing](Rgba c) { return missing < 0 ? c : asSeenByColourBlind(c, missing); };
        for (int i = 0; i < regionColourCount; ++i) {
            for (int j = 0; j < i; ++j) {
                const double distance = colourDistance(seen(regionColour(i)), seen(regionColour(j)));
                QVERIFY2(distance > (missing < 0 ? 20.0 : 13.0),
                         qPrintable(QString("%1 and %2 seen without cone %3: %4")
                                        .arg(i)
                                        .arg(j)
                                        .arg(missing)
                                        .arg(distance)));
            }
        }
    }
    QCOMPARE(regionColour(23), regionColour(3));
    QCOMPARE(regionColour(-1), regionColour(19));
}

void RegionColoursTest::distanceKnowsPublishedValues()
{
    // L* of black and white are 0 and 100, both without colour.
    QVERIFY(std::abs(colourDistance({0, 0, 0, 255}, {255, 255, 255, 255}) - 100.0) < 0.05);
    // sRGB red is L*a*b* 53.24, 80.09, 67.20; green 87.73, -86.18, 83.18.
    QVERIFY(std::abs(colourDistance({255, 0, 0, 255}, {0, 255, 0, 255}) - 170.57) < 0.2);
    // Without red or green cones greys stay greys.
    for (int missing = 0; missing < 2; ++missing)
        QVERIFY(colourDistance({128, 128, 128, 255}, asSeenByColourBlind({128, 128, 128, 255}, missing)) <
                2.0);
    // A red and a green that are far apart look alike without red cones.
    const Rgba a = asSeenByColourBlind({170, 60, 40, 255}, 1),
               b = asSeenByColourBlind({110, 110, 30, 255}, 1);
    QVERIFY(colourDistance(a, b) < 0.4 * colourDistance({170, 60, 40, 255}, {110, 110, 30, 255}));
}

void RegionColoursTest::neighboursNeverShareAColour()
{
    Random random(11);
    for (int trial = 0; trial < 50; ++trial) {
        const int count = 2 + random.index(300);
        std::vector<std::pair<int, int>> pairs;
        for (int i = 0; i < 3 * count; ++i)
            pairs.emplace_back(random.index(count), random.index(count));
        const std::vector<int> colours = assignRegionColours(count, pairs);
        QCOMPARE(int(colours.size()), count);
        for (const auto &[a, b] : pairs) {
            if (a != b)
                QVERIFY(regionColour(colours[std::size_t(a)]) != regionColour(colours[std::size_t(b)]));
        }
    }
}

void RegionColoursTest::fewRegionsGetDifferentColours()
{
    const std::vector<int> colours = assignRegionColours(20, {{0, 1}, {1, 2}, {2, 3}});
    QCOMPARE(std::set<int>(colours.begin(), colours.end()).size(), std::size_t(20));
}

void RegionColoursTest::orderOfNeighboursDoesNotMatter()
{
    Random random(5);
    std::vector<std::pair<int, int>> pairs;
    for (int i = 0; i < 200; ++i)
        pairs.emplace_back(random.index(60), random.index(60));
    const std::vector<int> first = assignRegionColours(60, pairs);
    random.shuffle(pairs);
    for (auto &pair : pairs)
        std::swap(pair.first, pair.second);
    QCOMPARE(assignRegionColours(60, pairs), first);
}

void RegionColoursTest::crowdedAndWrongInput()
{
    // 25 regions that all touch: numbers beyond the palette, but still all different.
    std::vector<std::pair<int, int>> pairs{{-1, 3}, {3, 400}, {2, 2}};
    for (int i = 0; i < 25; ++i) {
        for (int j = 0; j < i; ++j)
            pairs.emplace_back(i, j);
    }
    const std::vector<int> colours = assignRegionColours(25, pairs);
    QCOMPARE(std::set<int>(colours.begin(), colours.end()).size(), std::size_t(25));
    QVERIFY(assignRegionColours(0, pairs).empty());
    QVERIFY(assignRegionColours(-4, pairs).empty());
}

QTEST_APPLESS_MAIN(RegionColoursTest)
#include "region_colours_test.moc"
