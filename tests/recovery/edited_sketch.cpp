#include "recovery/edited_document.h"
#include "sketchsurfacer/document/sketch_document.h"

#include <cmath>

namespace ductus {

namespace {

constexpr int sketchStrokes = 150, strokePoints = 40; // about as large as most sketches

class EditedSketch : public EditedDocument
{
public:
    Document &document() override { return mDocument; }
    void start() override
    {
        StrokeSet set;
        set.strokes.resize(sketchStrokes);
        for (int i = 0; i < sketchStrokes; ++i) {
            Stroke &stroke = set.strokes[std::size_t(i)];
            stroke.id = StrokeId{i};
            for (int k = 0; k < strokePoints; ++k) {
                const double turn = 0.05 * k + 0.3 * i;
                stroke.points.emplace_back(2.0 * std::cos(turn), 0.01 * i, 2.0 * std::sin(turn));
            }
        }
        mDocument.start(std::move(set), defaultSurfaceOptions(), QStringLiteral("barrel"));
    }
    int editCount() const override
    {
        const std::vector<Stroke> &strokes = mDocument.strokes().strokes;
        if (strokes.size() < sketchStrokes)
            return -1;
        for (std::size_t i = sketchStrokes; i < strokes.size(); ++i) {
            const std::vector<Vec3> &points = strokes[i].points;
            if (!isLine({points.begin(), points.end()}, int(i) - sketchStrokes + 1))
                return -1;
        }
        return int(strokes.size()) - sketchStrokes;
    }

protected:
    bool addLine(int number) override
    {
        mDocument.addStroke(lineOf(number));
        return true;
    }

private:
    SketchDocument mDocument;
};

} // namespace

std::unique_ptr<EditedDocument> editedSketch()
{
    return std::make_unique<EditedSketch>();
}

} // namespace ductus
