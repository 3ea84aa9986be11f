#include "imaging/ambiguity_colours.h"

#include <QtTest>

using namespace ductus;

class AmbiguityColoursTest : public QObject
{
    Q_OBJECT
private slots:
    void darkerIsMoreOpen();
    void valuesBeyondTheRangeAreItsEnds();
};

void AmbiguityColoursTest::darkerIsMoreOpen()
{
    double before = 1e9;
    for (double value : {0.1, 0.2, 0.35, 0.5, 0.7, 0.85, 1.0}) {
        const Rgba c = ambiguityColour(value);
        const double lightness = 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
        QVERIFY(lightness < before);
        before = lightness;
    }
}

void AmbiguityColoursTest::valuesBeyondTheRangeAreItsEnds()
{
    QVERIFY(ambiguityColour(-1.0) == ambiguityColour(0.0));
    QVERIFY(ambiguityColour(7.0) == ambiguityColour(1.0));
}

QTEST_GUILESS_MAIN(AmbiguityColoursTest)
#include "ambiguity_colours_test.moc"
