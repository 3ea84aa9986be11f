// FrameStrip: the drawings of a canvas as small pictures: [1] [2] [3] [+], with how long each is shown, how
// they repeat, and the onion skin.
#pragma once

#include "doodlestudio/ui/canvases/studio_state.h"

#include <QWidget>

class QComboBox;
class QHBoxLayout;
class QSpinBox;
class QToolButton;

namespace ductus {

class FrameStrip : public QWidget
{
    Q_OBJECT
public:
    explicit FrameStrip(StudioState &state, QWidget *parent = nullptr);

    /// An empty drawing after the present one.
    void addDrawing();
    void duplicateDrawing();
    void removeDrawing();
    void step(int drawings);
    void setOnionSkin(bool on);

private:
    void refresh();
    void buildControls();
    QImage thumbnail(const Canvas &canvas, int index) const;
    void edit(const QString &text, Result<Doodle> doodle);

    StudioState &mState;
    QHBoxLayout *mFrames;
    QWidget *mControls;
    QSpinBox *mHold;
    QComboBox *mRepeat;
    QToolButton *mOnion;
    QSpinBox *mOnionCount;
    std::vector<std::vector<MarkPointer>> mShown; // what the small pictures show
    bool mIsRefreshing = false;
};

} // namespace ductus
