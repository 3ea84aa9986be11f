// SketchDocument: one sketch with the user's decisions, their history, and the results they gave. Results are
// kept for every content of the history that was solved, so undoing a scribble brings the old surface back at
// once.
#pragma once

#include "document/document.h"
#include "sketchsurfacer/document/sketch_content.h"
#include "strokes/bend.h"

#include <QImage>
#include <deque>
#include <map>

namespace ductus {

/// Something of the content is another: see the flags.
struct SketchChanged : ChangeEvent
{
    bool strokes = false; // points, roles, unit or axes
    bool options = false;
    bool scribbles = false;
    bool proxy = false; // the given one
};

/// shownResult() is another.
struct ResultChanged : ChangeEvent
{
};

class SketchDocument : public Document
{
    Q_OBJECT
public:
    explicit SketchDocument(QObject *parent = nullptr);

    const SketchContent &content() const { return mContent; }
    const StrokeSet &strokes() const { return *mContent.strokes; }
    bool isEmpty() const { return strokes().strokes.empty(); }

    /// A new, unsaved document of \a strokes; the history begins here.
    void start(StrokeSet strokes, const SurfaceOptions &options, const QString &name);

    // Edits: each is one step of the history.
    void setRole(const std::vector<StrokeId> &strokes, StrokeRole role, quint64 drag = 0);
    void setOptions(const QString &text, const SurfaceOptions &options, quint64 drag = 0);
    void addScribble(const Scribble &scribble);
    void removeScribble(int index);
    void clearScribbles();
    /// The id of the new stroke.
    StrokeId addStroke(const std::vector<Vec3> &points, StrokeRole role = StrokeRole::Surface);
    /// Several in one step of the history; the ids of the new strokes.
    std::vector<StrokeId> addStrokes(const std::vector<std::vector<Vec3>> &lines,
                                     StrokeRole role = StrokeRole::Surface);
    /// Strokes of another app as one step; they get new ids and keep pressure, time and role.
    std::vector<StrokeId> pasteStrokes(std::vector<Stroke> strokes);
    /// By \a way, in the unit of the sketch.
    void moveStrokes(const std::vector<StrokeId> &strokes, const Vec3 &way);
    void bendStroke(StrokeId stroke, const StrokeBend &bend);
    void deleteStrokes(const std::vector<StrokeId> &strokes);
    void setGivenProxy(std::shared_ptr<const TriangleMesh> proxy);
    void setUnit(double metresPerUnit, UpAxis up);
    /// Another surface the strokes allow: \a labelled is of the present strokes. Scribbles go, as they were
    /// about the former one.
    void chooseReading(std::shared_ptr<const SurfacingState> labelled);
    /// The next surface does not continue from the ones before. After many small edits of strokes it may come
    /// out otherwise than all of them in one.
    void startAnew();

    /// What goes into the next snapshot as the project's picture; no edit. Null: the one it has stays.
    void setPicture(const QImage &picture) { mPicture = picture; }

    // Results.
    /// Of exactly this content, or null.
    std::shared_ptr<const SurfacingState> result() const;
    /// What is to be seen: the result, or a preview of it, or the last one as long as there is none.
    std::shared_ptr<const SurfacingState> shownResult() const { return mShown; }
    /// The plane the sketch is mirrored at, as given or as it was found by the surface that is shown.
    std::optional<SymmetryPlane> symmetryPlane() const;
    bool isUpToDate() const { return result() != nullptr; }
    /// A state to continue from and the content it was made of; null if everything must be made. Of the same
    /// strokes and proxy if there is one (see hasSameInput), else one whose labels changed strokes can be
    /// worked into (surfacing/pipeline/stroke_update.h): the one that is shown before others.
    std::shared_ptr<const SurfacingState> startingPoint(SketchContent *madeOf) const;
    /// The result of the content with \a contentId, which may have been left meanwhile.
    void setResult(const SketchContent &madeOf, std::shared_ptr<const SurfacingState> state);
    /// Labels of a result that is still being made.
    void setPreview(std::uint64_t contentId, std::shared_ptr<const SurfacingState> state);
    /// The preview is not going to become a result: back to what was shown before.
    void dropPreview();

protected:
    Result<void> readFrom(const Project &project) override;
    void writeTo(Project &project) const override;
    void clear() override;

private:
    struct Kept
    {
        SketchContent content;
        std::shared_ptr<const SurfacingState> state;
    };

    std::vector<StrokeId> append(const QString &text, std::vector<Stroke> added);
    void edit(const QString &text, SketchContent next, quint64 drag = 0);
    void apply(const SketchContent &content);
    void showResult();
    const Kept *kept(std::uint64_t contentId) const;
    const Kept *keptOfSameInput() const;
    const Kept *keptOfOtherStrokes() const;

    SketchContent mContent;
    std::deque<Kept> mResults; // oldest first
    std::shared_ptr<const SurfacingState> mShown;
    std::uint64_t mLastId = 0;
    Uuid mDocumentId = Uuid::create();
    QImage mPicture;
};

} // namespace ductus
