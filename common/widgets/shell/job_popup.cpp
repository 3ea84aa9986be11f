#include "widgets/shell/job_popup.h"

#include "widgets/shell/job_row.h"

#include <QLabel>
#include <QVBoxLayout>

namespace ductus {

namespace {

constexpr int popupWidth = 360;

} // namespace

JobPopup::JobPopup(JobRunner &runner, QWidget *parent)
    : QFrame(parent, Qt::Popup), mRunner(runner), mRows(new QVBoxLayout),
      mEmpty(new QLabel(tr("Nothing is running.")))
{
    setObjectName(QStringLiteral("jobPopup"));
    setAccessibleName(tr("Running jobs"));
    setFixedWidth(popupWidth);
    mEmpty->setProperty("dim", true);
    auto *heading = new QLabel(tr("Running jobs"));
    heading->setProperty("caption", true);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 16, 16);
    layout->setSpacing(12);
    layout->addWidget(heading);
    layout->addLayout(mRows);
    layout->addWidget(mEmpty);
    mRows->setSpacing(16);
    connect(&runner, &JobRunner::jobStarted, this, &JobPopup::refresh);
    connect(&runner, &JobRunner::jobProgress, this, &JobPopup::refresh);
    connect(&runner, &JobRunner::jobFinished, this, &JobPopup::refresh);
}

void JobPopup::openAbove(const QWidget &anchor)
{
    mAnchor = &anchor;
    refresh();
    show();
    refresh(); // now with its true height
    setFocus();
}

void JobPopup::refresh()
{
    if (!mAnchor)
        return;
    const QList<JobState> states = mRunner.jobs();
    for (auto it = mRowOf.begin(); it != mRowOf.end();) {
        if (mRunner.job(it->first)) {
            ++it;
            continue;
        }
        it->second->deleteLater();
        it->second->hide();
        mRows->removeWidget(it->second);
        it = mRowOf.erase(it);
    }
    for (const JobState &state : states) {
        if (state.spec.isQuiet)
            continue;
        JobRow *&row = mRowOf[state.id];
        if (!row) {
            row = new JobRow(state.id);
            connect(row, &JobRow::cancelRequested, this, [this](JobId id) { mRunner.cancel(id); });
            mRows->addWidget(row);
        }
        row->show(state);
    }
    mEmpty->setVisible(mRowOf.empty());
    adjustSize();
    const QPoint corner = mAnchor->mapToGlobal(QPoint(mAnchor->width(), 0));
    move(corner - QPoint(width(), height() + 8));
}

} // namespace ductus
