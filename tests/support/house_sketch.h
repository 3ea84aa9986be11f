// The sketch of tests about what is missing: a house of which nobody drew the ridge.
#pragma once

#include "sketchsurfacer/ui/testing/app_under_test.h"
#include "support/sketch_synthesis.h"
#include "support/solids.h"

namespace ductus::testing {

// As other programs would have written it.
inline QByteArray houseWithoutRidge()
{
    const Solid solid = house();
    SketchSynthesisOptions options;
    options.seed = 3;
    const SyntheticSketch whole = synthesizeSketch(solid, options);
    QByteArray text;
    for (std::size_t i = 0; i < whole.strokes.strokes.size(); ++i) {
        if (solid.curves[std::size_t(whole.strokeCurves[i])].name == "ridge")
            continue;
        const std::vector<Vec3> &points = whole.strokes.strokes[i].points;
        text += "v " + QByteArray::number(int(points.size())) + '\n';
        for (const Vec3 &p : points)
            text += QByteArray::number(p.x(), 'g', 17) + ' ' + QByteArray::number(p.y(), 'g', 17) + ' ' +
                    QByteArray::number(p.z(), 'g', 17) + '\n';
    }
    return text;
}

// Opened from a file and surfaced; smaller than usual, as the tests have to wait for it.
inline bool surfaceHouseWithoutRidge(App &app, int proxyVertices, int runs)
{
    QFile file(app.dir.filePath("house.curves"));
    if (!file.open(QIODevice::WriteOnly))
        return false;
    file.write(houseWithoutRidge());
    file.close();
    SketchDocument &sketch = app.window->sketch();
    app.window->openPath(file.fileName());
    if (!QTest::qWaitFor([&] { return !sketch.isEmpty(); }, 20'000))
        return false;
    app.chooseQuickOptions(proxyVertices, runs); // without symmetry: its plane would run along the ridge
    app.press(Qt::Key_Return, Qt::ControlModifier);
    return app.waitForResult();
}

} // namespace ductus::testing
