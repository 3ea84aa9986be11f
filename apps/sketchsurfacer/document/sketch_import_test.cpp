#include "sketchsurfacer/document/sketch_import.h"

#include "support/box_sketch.h"

#include <QtTest>

using namespace ductus;

namespace {

QByteArray asObj(const StrokeSet &set)
{
    QByteArray text;
    int next = 1;
    for (const Stroke &stroke : set.strokes) {
        QByteArray line("l");
        for (const Vec3 &p : stroke.points) {
            text += "v " + QByteArray::number(p.x(), 'g', 12) + ' ' + QByteArray::number(p.y(), 'g', 12) +
                    ' ' + QByteArray::number(p.z(), 'g', 12) + '\n';
            line += ' ' + QByteArray::number(next++);
        }
        text += line + '\n';
    }
    return text;
}

} // namespace

class SketchImportTest : public QObject
{
    Q_OBJECT

private slots:
    void cableIsMarkedAndTold()
    {
        StrokeSet sketch = boxSketch({Vec3(0.4, 0.4, 0.4), {}});
        const int boxStrokes = int(sketch.strokes.size());
        const Result<ImportedSketch> box = importSketchText(asObj(sketch), QStringLiteral("box.obj"), {});
        QVERIFY(box);
        QVERIFY(box->cables.empty());

        Stroke cable;
        cable.points = {{0.4, 0.4, 0.4}, {1.0, 0.9, 0.4}, {2.0, 0.9, 0.6}};
        sketch.strokes.push_back(cable);
        const Result<ImportedSketch> lamp = importSketchText(asObj(sketch), QStringLiteral("lamp.obj"), {});
        QVERIFY(lamp);
        QCOMPARE(lamp->cables, std::vector<int>{boxStrokes});
        for (int s = 0; s <= boxStrokes; ++s)
            QVERIFY((lamp->strokes.strokes[std::size_t(s)].role == StrokeRole::Skeletal) ==
                    (s == boxStrokes));
    }

    void emptyTextSaysWhy()
    {
        const Result<ImportedSketch> nothing = importSketchText("# nothing\n", QStringLiteral("n.obj"), {});
        QVERIFY(!nothing);
        QVERIFY(!nothing.error().remedy.empty());
    }
};

QTEST_GUILESS_MAIN(SketchImportTest)
#include "sketch_import_test.moc"
