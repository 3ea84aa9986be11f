// CanvasPanel: the chosen canvas in words and numbers: whether it follows, how far and how large it is, what
// hides it.
#pragma once

#include "doodlestudio/ui/canvases/studio_state.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace ductus {

class NumberSlider;
class SegmentedSwitch;

class CanvasPanel : public QWidget
{
    Q_OBJECT
public:
    explicit CanvasPanel(StudioState &state, QWidget *parent = nullptr);

    /// Makes the chosen canvas follow what is under it now, or stand where it is now.
    void setFollows(bool follows);
    /// A keyframe where the chosen canvas is now.
    void pinHere();
    /// Whether the canvas goes straight from the pin before this frame to the next one. Nothing outside of
    /// pins.
    void setStraight(bool straight);
    void faceCamera();
    void useSceneDistance();

    enum class OcclusionBrush { Off, InFront, Behind };
    void setOcclusionBrush(OcclusionBrush brush);

signals:
    void occlusionBrushChosen(ductus::CanvasPanel::OcclusionBrush brush);

private:
    void buildPlace(QVBoxLayout *layout);
    void buildHiding(QVBoxLayout *layout);
    void refresh();
    std::optional<int> pinBefore() const; // whose segment the present frame is in
    void editDistance(double depth);
    void editSize(double percent);
    template <typename Change>
    void change(const QString &text, Change change, quint64 drag = 0);

    StudioState &mState;
    QLabel *mEmpty;
    QWidget *mContent;
    SegmentedSwitch *mMotion;
    QPushButton *mPin;
    QLabel *mKeyframes;
    NumberSlider *mDistance;
    QPushButton *mSceneDistance;
    NumberSlider *mSize;
    NumberSlider *mOpacity;
    QComboBox *mTurns;
    QCheckBox *mStraight;
    QCheckBox *mIsHidden;
    NumberSlider *mBias;
    QPushButton *mInFront;
    QPushButton *mBehind;
    QPushButton *mForgetBrush;
    quint64 mDrag = 0;
};

} // namespace ductus
