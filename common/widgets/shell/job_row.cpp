#include "widgets/shell/job_row.h"

#include "widgets/controls/thin_bar.h"
#include "widgets/shell/job_words.h"
#include "widgets/theme/icons.h"

#include <QGridLayout>
#include <QLabel>
#include <QToolButton>

namespace ductus {

JobRow::JobRow(JobId id, QWidget *parent)
    : QWidget(parent), mTitle(new QLabel), mStage(new QLabel), mTime(new QLabel), mBar(new ThinBar),
      mCancel(new QToolButton)
{
    mTitle->setProperty("heading", true);
    mStage->setProperty("dim", true);
    mTime->setProperty("dim", true);
    mCancel->setIcon(icon(QStringLiteral("close")));
    mCancel->setIconSize({16, 16});
    mCancel->setFixedSize(28, 28);
    mCancel->setToolTip(tr("Stop this job; what was there before stays."));
    auto *layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setHorizontalSpacing(8);
    layout->setVerticalSpacing(4);
    layout->addWidget(mTitle, 0, 0, 1, 2);
    layout->addWidget(mCancel, 0, 2);
    layout->addWidget(mBar, 1, 0, 1, 3);
    layout->addWidget(mStage, 2, 0);
    layout->addWidget(mTime, 2, 1, 1, 2, Qt::AlignRight);
    layout->setColumnStretch(0, 1);
    connect(mCancel, &QToolButton::clicked, this, [this, id] { emit cancelRequested(id); });
}

void JobRow::show(const JobState &state)
{
    mTitle->setText(state.spec.title);
    mCancel->setAccessibleName(tr("Cancel %1").arg(state.spec.title));
    mCancel->setVisible(state.spec.canCancel && !state.isCancelling);
    mBar->setFraction(state.fraction);
    mStage->setText(state.isCancelling ? tr("Stopping") : state.isWaiting ? tr("Waiting") : state.text);
    QStringList time{percentWords(state.fraction)};
    if (const QString rest = remainingWords(state.remainingSeconds); !rest.isEmpty())
        time << rest;
    mTime->setText(time.join(QStringLiteral("  \u00b7  ")));
    mBar->setAccessibleName(state.spec.title);
    QWidget::show();
}

} // namespace ductus
