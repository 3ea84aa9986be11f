// TransportBar: the row above the timeline: play, the time, how the scene was found in words.
#pragma once

#include <QWidget>

class QAction;
class QHBoxLayout;
class QLabel;
class QToolButton;

namespace ductus {

class Playback;

class TransportBar : public QWidget
{
    Q_OBJECT
public:
    explicit TransportBar(Playback &playback, QWidget *parent = nullptr);

    /// Buttons, from left to right.
    void addButton(QAction *action);
    /// How the camera was found; a tooltip says what that limits.
    void setSceneWords(const QString &words, const QString &teaches);
    QString sceneWords() const;

private:
    void showTime();

    Playback &mPlayback;
    QHBoxLayout *mButtons;
    QLabel *mTime;
    QLabel *mScene;
};

} // namespace ductus
