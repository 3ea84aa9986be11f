#include "widgets/shell/job_chip.h"

#include "widgets/shell/job_popup.h"
#include "widgets/shell/job_words.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QPainterPath>
#include <QToolButton>

namespace ductus {

namespace {

constexpr int chipHeight = 20;
constexpr int longestWords = 360; // pixels

} // namespace

// The words, with the progress as the ground that fills from the left.
class JobChip::Face : public QAbstractButton
{
public:
    void show(const QString &text, double fraction)
    {
        setText(text);
        mFraction = fraction;
        setAccessibleName(text);
        // On the grid and not shrinking with every digit, so that it does not tremble.
        const int wanted = std::min(longestWords, fontMetrics().horizontalAdvance(text)) + 22;
        if (wanted > width() || wanted < width() - 48 || !isVisible())
            setFixedSize((wanted + 7) / 8 * 8, chipHeight);
        update();
    }

protected:
    void paintEvent(QPaintEvent *) override
    {
        const ThemeColours colours = coloursOf(palette());
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const QRectF box = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
        QPainterPath shape;
        shape.addRoundedRect(box, 6.0, 6.0);
        painter.fillPath(shape, underMouse() ? colours.hover : colours.raised);
        painter.save();
        painter.setClipPath(shape);
        painter.fillRect(QRectF(0.0, 0.0, width() * mFraction, height()),
                         mixed(colours.panel, colours.accent, colours.isDark ? 0.32 : 0.22));
        painter.fillRect(QRectF(0.0, height() - 2.5, width() * mFraction, 2.0), colours.accent);
        painter.restore();
        painter.setPen(QPen(hasFocus() ? colours.accent : colours.line, 1.0));
        painter.drawPath(shape);
        painter.setPen(colours.text);
        const QString shown = fontMetrics().elidedText(text(), Qt::ElideMiddle, width() - 20);
        painter.drawText(rect().adjusted(10, 0, -10, -1), Qt::AlignVCenter | Qt::AlignLeft, shown);
    }

private:
    double mFraction = 0.0;
};

JobChip::JobChip(JobRunner &runner, QWidget *parent)
    : QWidget(parent), mRunner(runner), mFace(new Face), mCancel(new QToolButton)
{
    setAccessibleName(tr("Running jobs"));
    mFace->setFocusPolicy(Qt::TabFocus);
    mFace->setToolTip(tr("What is being worked on. Click for the list."));
    mCancel->setIcon(icon(QStringLiteral("close")));
    mCancel->setIconSize({16, 16});
    mCancel->setFixedSize(chipHeight, chipHeight);
    mCancel->setFocusPolicy(Qt::TabFocus);
    mCancel->setAccessibleName(tr("Cancel job"));
    mCancel->setToolTip(tr("Stop this job; what was there before stays."));
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(mFace);
    layout->addWidget(mCancel);
    connect(mFace, &QAbstractButton::clicked, this, &JobChip::openList);
    connect(mCancel, &QToolButton::clicked, this, [this] {
        for (const JobState &state : mRunner.jobs()) {
            if (!state.spec.isQuiet && state.spec.canCancel && !state.isCancelling) {
                mRunner.cancel(state.id);
                return;
            }
        }
    });
    connect(&runner, &JobRunner::jobStarted, this, &JobChip::refresh);
    connect(&runner, &JobRunner::jobProgress, this, &JobChip::refresh);
    connect(&runner, &JobRunner::jobFinished, this, &JobChip::refresh);
    refresh();
}

QString JobChip::text() const
{
    return isHidden() ? QString() : mFace->text();
}

void JobChip::refresh()
{
    QList<JobState> states = mRunner.jobs();
    states.removeIf([](const JobState &state) { return state.spec.isQuiet; });
    setVisible(!states.isEmpty());
    if (states.isEmpty())
        return;
    // The newest that is at work: it is what the user just asked for.
    JobState shown = states.last();
    for (const JobState &state : states) {
        if (!state.isCancelling && !state.isWaiting)
            shown = state;
    }
    QString words = jobLine(shown);
    if (!shown.isCancelling && !shown.isWaiting) {
        words += QStringLiteral("  ") + percentWords(shown.fraction);
        if (const QString rest = remainingWords(shown.remainingSeconds); !rest.isEmpty())
            words += QStringLiteral("  ") + QChar(0x00b7) + QStringLiteral("  ") + rest;
    }
    if (states.size() > 1)
        words += QStringLiteral("  +%1").arg(states.size() - 1);
    mFace->show(words, shown.fraction);
    mCancel->setVisible(shown.spec.canCancel && !shown.isCancelling);
}

void JobChip::openList()
{
    if (!mPopup)
        mPopup = new JobPopup(mRunner, this);
    mPopup->openAbove(*this);
}

} // namespace ductus
