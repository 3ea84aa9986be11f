#include "sketchsurfacer/document/surfacing_jobs.h"

#include "sketchsurfacer/document/stored_reading.h"

#include <QPointer>

namespace ductus {

namespace {

const QString jobKey = QStringLiteral("surface");
constexpr int followAfterMilliseconds = 120; // edits that come together are solved together

using StatePointer = std::shared_ptr<const SurfacingState>;

} // namespace

SurfacingJobs::SurfacingJobs(SketchDocument &document, JobRunner &runner, QObject *parent)
    : QObject(parent), mDocument(document), mRunner(runner)
{
    mFollow.setSingleShot(true);
    mFollow.setInterval(followAfterMilliseconds);
    connect(&mFollow, &QTimer::timeout, this, &SurfacingJobs::start);
    connect(&document, &Document::changed, this, &SurfacingJobs::onChanged);
}

void SurfacingJobs::onChanged(const ChangeEvent &event)
{
    if (event.as<DocumentReset>()) {
        mFollow.stop();
        cancel();
        return;
    }
    if (!event.as<SketchChanged>())
        return;
    if (mDocument.isUpToDate()) { // undone to something known
        mFollow.stop();
        cancel();
    } else if (mFollowsEdits && (isRunning() || mDocument.shownResult())) {
        mFollow.start();
    }
}

void SurfacingJobs::start()
{
    mFollow.stop();
    const SketchContent content = mDocument.content();
    if (mDocument.isEmpty() || mDocument.isUpToDate() || mRunningId == content.id)
        return;
    SketchContent madeOf;
    StatePointer before = mDocument.startingPoint(&madeOf);
    const bool isOfInput = before && hasSameInput(madeOf, content);
    // A reading that was chosen goes before what there is of other strokes; one of a file is made again.
    const bool wantsReading =
        !isOfInput && content.reading && (!before || content.reading->strokes == content.strokes);
    const QPointer<SurfacingJobs> self(this);
    auto work = [content, known = before, isOfInput, wantsReading, self,
                 runner = &mRunner](const JobControl &whole) -> Result<StatePointer> {
        StatePointer before = known;
        bool sameInput = isOfInput;
        JobControl control = whole;
        if (wantsReading) {
            Result<StatePointer> reading = labelledReading(content, whole.part(0.0, 0.5));
            if (!reading)
                return reading.error();
            before = *reading;
            sameInput = content.reading->strokes == content.strokes;
            if (!content.reading->labelled)
                control = whole.part(0.5, 1.0);
        }
        const auto onPreview = [&](const SurfacingState &labelled) {
            auto preview = std::make_shared<const SurfacingState>(labelled);
            // Through the runner, which waits for its jobs: this object may go at any time.
            if (!control.isCancelled())
                QMetaObject::invokeMethod(
                    runner,
                    [self, preview, id = content.id] {
                        if (self && self->mRunningId == id)
                            self->mDocument.setPreview(id, preview);
                    },
                    Qt::QueuedConnection);
        };
        if (sameInput && before->hasLabels() && !before->hasSurface())
            onPreview(*before);
        Result<SurfacingState> state =
            resurface(before ? *before : SurfacingState(), requestOf(content), sameInput, onPreview, control);
        if (!state)
            return state.error();
        return StatePointer(std::make_shared<const SurfacingState>(std::move(*state)));
    };
    auto finish = [this, content](Result<StatePointer> state) {
        const bool isNewest = mRunningId == content.id;
        if (isNewest)
            mRunningId = 0;
        if (state) {
            mDocument.setResult(content, *state);
            QStringList warnings;
            for (const std::string &warning : (*state)->surface->warnings)
                warnings << QString::fromStdString(warning);
            if (isNewest && !warnings.isEmpty())
                emit noticed(warnings);
        } else if (isNewest) {
            mDocument.dropPreview();
            if (!state.error().isCancelled())
                emit failed(state.error());
        }
        if (isNewest)
            emit runningChanged(false);
    };
    mRunningId = content.id;
    mRunner.start<StatePointer>({jobKey, tr("Surfacing the sketch")}, this, work, finish);
    emit runningChanged(true);
}

void SurfacingJobs::cancel()
{
    mFollow.stop();
    mRunner.cancelKey(jobKey);
}

} // namespace ductus
