#include "doodlestudio/ui/timeline/transport_bar.h"

#include "doodlestudio/ui/player/playback.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace ductus {

TransportBar::TransportBar(Playback &playback, QWidget *parent) : QWidget(parent), mPlayback(playback)
{
    setFixedHeight(36);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 2, 12, 2);
    layout->setSpacing(8);
    mButtons = new QHBoxLayout;
    mButtons->setSpacing(2);
    mTime = new QLabel;
    mTime->setObjectName(QStringLiteral("time"));
    mScene = new QLabel;
    mScene->setObjectName(QStringLiteral("sceneWords"));
    mScene->setProperty("dim", true);
    layout->addLayout(mButtons);
    layout->addWidget(mTime);
    layout->addStretch(1);
    layout->addWidget(mScene);
    connect(&playback, &Playback::frameChanged, this, &TransportBar::showTime);
    showTime();
}

void TransportBar::addButton(QAction *action)
{
    auto *button = new QToolButton;
    button->setDefaultAction(action);
    button->setAutoRaise(true);
    button->setIconSize({20, 20});
    button->setFixedSize(32, 30);
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    mButtons->addWidget(button);
}

void TransportBar::setSceneWords(const QString &words, const QString &teaches)
{
    mScene->setText(words);
    mScene->setToolTip(teaches);
}

QString TransportBar::sceneWords() const
{
    return mScene->text();
}

void TransportBar::showTime()
{
    const double seconds = mPlayback.time();
    const int whole = int(seconds);
    const QString time = QStringLiteral("%1:%2.%3")
                             .arg(whole / 60)
                             .arg(whole % 60, 2, 10, QLatin1Char('0'))
                             .arg(int((seconds - whole) * 100), 2, 10, QLatin1Char('0'));
    mTime->setText(
        mPlayback.frameCount() > 0
            ? tr("%1   frame %2 of %3").arg(time).arg(mPlayback.frame() + 1).arg(mPlayback.frameCount())
            : QString());
}

} // namespace ductus
