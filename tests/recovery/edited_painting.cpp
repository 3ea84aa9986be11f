#include "layerpainter/document/painting_document.h"
#include "recovery/edited_document.h"
#include "support/painting_samples.h"

namespace ductus {

namespace {

class EditedPainting : public EditedDocument
{
public:
    Document &document() override { return mDocument; }
    void start() override
    {
        mDocument.start(planeOverClouds(), QStringLiteral("plane"));
        const auto made = mDocument.perform(act::AddStack{"Edits"});
        Q_ASSERT(made.ok());
    }
    int editCount() const override
    {
        const Layer *layer = ownLayer();
        if (!layer)
            return -1;
        const std::vector<Element> &elements = layer->drawings[0].elements;
        for (std::size_t i = 0; i < elements.size(); ++i) {
            std::vector<Eigen::Vector3d> points;
            for (const PaintedPoint &point : std::get<StrokeShape>(*elements[i].shape).points)
                points.push_back(point.position.cast<double>());
            if (!isLine(points, int(i) + 1))
                return -1;
        }
        return int(elements.size());
    }

protected:
    bool addLine(int number) override
    {
        StrokeShape stroke;
        for (const Eigen::Vector3d &point : lineOf(number))
            stroke.points.push_back(
                {point.cast<float>(), Eigen::Vector3f::UnitY(), 0.05f, {0.5f, 0.25f, 0.125f}, 1.0f});
        act::Draw draw;
        draw.layer = ownLayer()->id;
        draw.strokes = {std::make_shared<const ElementShape>(std::move(stroke))};
        return mDocument.perform(draw).ok();
    }

private:
    const Layer *ownLayer() const
    {
        const auto &stacks = mDocument.painting().stacks;
        return stacks.empty() || stacks.back().name != "Edits" ? nullptr : &*stacks.back().substrate;
    }
    PaintingDocument mDocument;
};

} // namespace

std::unique_ptr<EditedDocument> editedPainting()
{
    return std::make_unique<EditedPainting>();
}

} // namespace ductus
