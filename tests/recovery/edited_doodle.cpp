#include "doodlestudio/document/doodle_document.h"
#include "doodling/canvas/edit_doodle.h"
#include "doodling/canvas/edit_scene.h"
#include "recovery/edited_document.h"

namespace ductus {

namespace {

class EditedDoodle : public EditedDocument
{
public:
    Document &document() override { return mDocument; }
    void start() override
    {
        // The clip need not be there: what is drawn on it is the user's work.
        mDocument.start(QStringLiteral("/nowhere/clip.mp4"),
                        ClipReference{"/nowhere/clip.mp4", 48, 320, 180, 24.0});
        Canvas canvas;
        canvas.name = "Edits";
        canvas.keyframes.positions = {{0, Vec2(160, 90), 3.0, false}};
        const bool isAdded =
            mDocument.edit(QStringLiteral("Place canvas"), withCanvas(mDocument.scene(), canvas));
        Q_ASSERT(isAdded);
    }
    int editCount() const override
    {
        if (mDocument.scene().canvases.size() != 1)
            return -1;
        const std::vector<MarkPointer> &marks = mDocument.scene().canvases[0].doodle.frames[0].marks;
        for (std::size_t i = 0; i < marks.size(); ++i) {
            const auto *line = std::get_if<InkStroke>(marks[i].get());
            if (!line || !isLine({line->line.points.begin(), line->line.points.end()}, int(i) + 1))
                return -1;
        }
        return int(marks.size());
    }

protected:
    bool addLine(int number) override
    {
        const Canvas &canvas = mDocument.scene().canvases[0];
        InkStroke stroke;
        for (const Eigen::Vector3d &point : lineOf(number)) {
            stroke.line.points.push_back(point);
            stroke.line.pressure.push_back(0.5);
        }
        return mDocument.editDoodle(QStringLiteral("Draw line"), canvas.id,
                                    withMark(canvas.doodle, 0, stroke));
    }

private:
    DoodleDocument mDocument;
};

} // namespace

std::unique_ptr<EditedDocument> editedDoodle()
{
    return std::make_unique<EditedDoodle>();
}

} // namespace ductus
