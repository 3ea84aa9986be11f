// MotionBar: the timeline: plays motion, drawings and the camera path, and keeps views as keys of that path.
#pragma once

#include "layerpainter/document/painting_document.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QLabel;
class QToolButton;

namespace ductus {

class KeyTrack;
class MotionTracks;
class NumberSlider;
class PaintingView;

class MotionBar : public QWidget
{
    Q_OBJECT
public:
    MotionBar(PaintingDocument &document, PaintingView &view, QWidget *parent = nullptr);

    MotionTracks &tracks() { return *mTracks; }
    bool isPlaying() const { return mTimer.isActive(); }
    void setPlaying(bool playing);
    void setSeconds(double seconds);
    /// Keeps where the view is as the camera's at the playhead's time; another key there is replaced.
    void keepView();
    void removeKey();

private:
    void advance();
    void refresh();
    void show(double seconds);
    QToolButton *button(const QString &icon, const QString &name, const QString &teaches);

    PaintingDocument &mDocument;
    PaintingView &mView;
    KeyTrack *mTrack;
    MotionTracks *mTracks;
    QLabel *mText;
    QToolButton *mPlay, *mFollow, *mRemove;
    NumberSlider *mLength;
    quint64 mDrag = 0;
    QTimer mTimer;
    QElapsedTimer mClock; // since the last step
};

} // namespace ductus
