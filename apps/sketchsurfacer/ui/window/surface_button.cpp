#include "sketchsurfacer/ui/window/surface_button.h"

#include "surfacing/sketch/point_cloud.h"
#include "widgets/controls/thin_bar.h"

#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

namespace ductus {

SurfaceButton::SurfaceButton(SketchDocument &document, SurfacingJobs &jobs, JobRunner &runner,
                             QWidget *parent)
    : QWidget(parent), mDocument(document), mJobs(jobs)
{
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(6);
    mButton = new QPushButton;
    mButton->setObjectName(QStringLiteral("surfaceButton"));
    mButton->setMinimumHeight(40);
    mButton->setProperty("primary", true);
    mProgress = new ThinBar;
    mProgress->setAccessibleName(tr("Progress"));
    QSizePolicy keep = mProgress->sizePolicy();
    keep.setRetainSizeWhenHidden(true); // nothing jumps when it starts
    mProgress->setSizePolicy(keep);
    mState = new QLabel;
    mState->setWordWrap(true);
    mState->setProperty("dim", true);
    rows->addWidget(mButton);
    rows->addWidget(mProgress);
    rows->addWidget(mState);
    connect(mButton, &QPushButton::clicked, this, [this] {
        if (mJobs.isRunning())
            mJobs.cancel();
        else
            emit surfaceRequested();
    });
    connect(&jobs, &SurfacingJobs::runningChanged, this, &SurfaceButton::refresh);
    connect(&document, &Document::changed, this, &SurfaceButton::refresh);
    connect(&runner, &JobRunner::jobProgress, this, &SurfaceButton::showProgress);
    refresh();
}

void SurfaceButton::refresh()
{
    const bool runs = mJobs.isRunning();
    const auto result = mDocument.result();
    mProgress->setVisible(runs);
    mButton->setEnabled(!mDocument.isEmpty() && (runs || !result));
    if (runs) {
        mButton->setText(tr("Stop"));
        mButton->setToolTip(tr("Stops and keeps the last surface (Esc)."));
        return;
    }
    mProgress->setFraction(0.0);
    mButton->setText(mDocument.shownResult() ? tr("&Update") : tr("&Surface it"));
    mButton->setToolTip(tr("Finds the surface the strokes describe (Ctrl+Enter)."));
    if (mDocument.isEmpty())
        mState->setText(tr("Open a sketch or draw strokes first."));
    else if (result && result->surface)
        mState->setText(tr("Up to date: %n regions", nullptr, int(result->surface->regions.size())) +
                        (result->timings.total > 0.05
                             ? tr(", %1 s").arg(locale().toString(result->timings.total, 'f', 1))
                             : QString()));
    else if (mDocument.shownResult())
        mState->setText(tr("The surface is older than the sketch."));
    else {
        const StrokeSet &strokes = mDocument.strokes();
        const int count = int(strokes.strokes.size());
        mState->setText(isPointCloud(strokes) ? tr("%n points, not surfaced yet.", nullptr, count)
                                              : tr("%n strokes, not surfaced yet.", nullptr, count));
    }
}

void SurfaceButton::showProgress(const JobState &state)
{
    if (state.spec.key != QLatin1String("surface") || !mJobs.isRunning())
        return;
    mProgress->setFraction(state.fraction);
    mState->setText(state.text);
}

} // namespace ductus
