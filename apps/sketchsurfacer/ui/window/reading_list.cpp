#include "sketchsurfacer/ui/window/reading_list.h"

#include <QIcon>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace ductus {

namespace {

constexpr QSize pictureSize(128, 80);
constexpr double asLikely = 1.03, nearlyAsLikely = 1.12; // energies, times that of the present surface

QIcon iconOf(const Image &image)
{
    const QImage shared(image.pixels.data(), image.width, image.height, 4 * image.width,
                        QImage::Format_RGBA8888);
    return QIcon(QPixmap::fromImage(shared.copy()));
}

} // namespace

ReadingList::ReadingList(AmbiguityPresenter &ambiguity, QWidget *parent)
    : QWidget(parent), mAmbiguity(ambiguity), mState(new QLabel), mLook(new QPushButton),
      mChoices(new QVBoxLayout)
{
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(6);
    mState->setWordWrap(true);
    mState->setProperty("dim", true);
    mLook->setText(tr("&Look for other readings"));
    mLook->setObjectName(QStringLiteral("lookForReadings"));
    mLook->setToolTip(
        tr("Colours where the strokes allow more than one surface, and offers the others (A)."));
    mChoices->setContentsMargins(0, 0, 0, 0);
    mChoices->setSpacing(6);
    rows->addWidget(mState);
    rows->addLayout(mChoices);
    rows->addWidget(mLook);
    connect(mLook, &QPushButton::clicked, this, &ReadingList::lookRequested);
    connect(&ambiguity, &AmbiguityPresenter::changed, this, &ReadingList::refresh);
    refresh();
}

void ReadingList::refresh()
{
    const std::shared_ptr<const AmbiguityView> shown = mAmbiguity.shown();
    mLook->setVisible(!mAmbiguity.isOn());
    if (!mAmbiguity.isOn())
        mState->setText(tr("Where strokes are few, they allow more than one surface."));
    else if (mAmbiguity.isRunning())
        mState->setText(tr("Trying what else the strokes could mean..."));
    else if (!shown)
        mState->setText(tr("Surface the sketch to see what it leaves open."));
    else if (shown->readings.empty())
        mState->setText(tr("The strokes say enough: no other surface is nearly as likely."));
    else
        mState->setText(tr("The strokes could also mean this. Choose one, or draw a stroke where the surface "
                           "is coloured."));
    if (shown == mListed)
        return;
    mListed = shown;
    while (QLayoutItem *item = mChoices->takeAt(0)) {
        item->widget()->deleteLater(); // it may be the one whose click brought us here
        delete item;
    }
    for (int i = 0; shown && i < int(shown->readings.size()); ++i) {
        const Reading &reading = shown->readings[std::size_t(i)];
        auto *button = new QToolButton;
        button->setObjectName(QStringLiteral("reading%1").arg(i));
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        button->setIcon(iconOf(reading.picture));
        button->setIconSize(pictureSize);
        const QString regions = tr("%n regions", nullptr, reading.regionCount);
        const QString likely = reading.energy < asLikely         ? tr("as likely")
                               : reading.energy < nearlyAsLikely ? tr("nearly as likely")
                                                                 : tr("less likely");
        const QString gap = QStringLiteral("  "); // to the picture
        button->setText(gap + regions + QLatin1Char('\n') + gap + likely);
        button->setAccessibleName(tr("Other reading %1: %2, %3").arg(i + 1).arg(regions, likely));
        button->setToolTip(tr("Takes this surface instead. Undo brings the present one back."));
        connect(button, &QToolButton::clicked, this, [this, i] { emit chosen(i); });
        mChoices->addWidget(button);
    }
}

} // namespace ductus
