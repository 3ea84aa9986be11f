#include "widgets/controls/elided_text.h"
#include "widgets/testing/widget_test_main.h"

#include <QFontMetrics>

using namespace ductus;

class ElidedTextTest : public QObject
{
    Q_OBJECT
private slots:
    void shortTextIsLeftAlone()
    {
        QCOMPARE(elidedLines("A vase", QFont(), 400, 2), QString("A vase"));
        QCOMPARE(elidedLines("", QFont(), 400, 2), QString());
    }

    void linesBreakBetweenWords()
    {
        const QFontMetrics metrics{QFont()};
        const QString text = "one two three four";
        const int width = metrics.horizontalAdvance("one two three") + 4; // it is laid out in parts of pixels
        QCOMPARE(elidedLines(text, QFont(), width, 2), QString("one two three\nfour"));
    }

    void whatDoesNotFitEndsInAnEllipsis()
    {
        const QFontMetrics metrics{QFont()};
        const QString text = "one two three four five six seven eight nine";
        const int width = metrics.horizontalAdvance("one two three");
        const QStringList lines = elidedLines(text, QFont(), width, 2).split('\n');
        QCOMPARE(lines.size(), 2);
        QVERIFY(lines[1].endsWith(QChar(0x2026)));
        for (const QString &line : lines)
            QVERIFY(metrics.horizontalAdvance(line) <= width);
    }
};

DUCTUS_WIDGET_TEST_MAIN(ElidedTextTest)
#include "elided_text_test.moc"
