// SketchPresenter: keeps the viewport showing what the document holds. Strokes at once, results as soon as a
// worker has made them drawable; former results are kept drawable, so undo shows them without a wait.
#pragma once

#include "document/jobs/job_runner.h"
#include "sketchsurfacer/document/sketch_document.h"
#include "sketchsurfacer/ui/presentation/result_view.h"

#include <deque>

namespace ductus {

/// The colour a role has everywhere.
Rgba roleColour(StrokeRole role, bool dark);
/// Of a border nobody marked: between those of the roles.
Rgba foundBorderColour(bool dark);
/// The colour a kind of scribble has everywhere.
Rgba scribbleColour(ScribbleKind kind);

class SketchPresenter : public QObject
{
    Q_OBJECT
public:
    /// All must outlive this.
    SketchPresenter(SketchDocument &document, JobRunner &runner, SketchView &view, QObject *parent = nullptr);

    /// What is shown of the result; null before there is one.
    std::shared_ptr<const ResultView> resultView() const { return mShown; }
    /// Region of the shown result under \a hit, or -1.
    int regionOf(const RayHit &hit) const;

    void setSelection(std::vector<StrokeId> strokes);
    const std::vector<StrokeId> &selection() const { return mSelection; }
    StrokeId strokeId(int lineIndex) const;
    /// Index of the line of \a stroke, or -1.
    int lineOf(StrokeId stroke) const;
    /// Strokes the shown surface ends along although nobody marked them as its border.
    std::vector<StrokeId> foundBorders() const;
    /// Shows foundBorders() as plainly as marked ones.
    void setBordersPointedOut(bool on);
    void setDark(bool dark);

signals:
    void resultShown();
    void selectionChanged();

private:
    void onChanged(const ChangeEvent &event);
    void showStrokes();
    void showScribbles();
    void showExtent();
    void showResult();
    void adopt(std::shared_ptr<const ResultView> view);

    SketchDocument &mDocument;
    JobRunner &mRunner;
    SketchView &mView;
    std::shared_ptr<RegionPalette> mPalette = std::make_shared<RegionPalette>();
    std::deque<std::shared_ptr<const ResultView>> mKept; // oldest first
    std::shared_ptr<const ResultView> mShown;
    std::vector<StrokeId> mSelection;
    bool mBordersPointedOut = false;
    bool mDark = true;
};

} // namespace ductus
