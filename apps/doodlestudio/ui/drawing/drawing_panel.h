// DrawingPanel: everything for drawing on the chosen canvas: the pens, the sheet from the front, its
// drawings.
#pragma once

#include "doodlestudio/ui/drawing/drawing_view.h"
#include "doodlestudio/ui/drawing/frame_strip.h"

#include <QWidget>

class QButtonGroup;
class QComboBox;
class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace ductus {

class FlowLayout;
class NumberSlider;

class DrawingPanel : public QWidget
{
    Q_OBJECT
public:
    DrawingPanel(StudioState &state, DrawingHand &hand, QWidget *parent = nullptr);

    DrawingView &view() { return *mView; }
    FrameStrip &strip() { return *mStrip; }
    void setTool(DrawingTool tool);
    void setColour(const QColor &colour);
    /// Larger (> 0) or smaller by one step.
    void changeWidth(int steps);
    QLineEdit *words() { return mWords; }
    /// A picture from a file on the middle of the canvas, to be moved from there. Files that are none are
    /// told by DoodleDocument::refused().
    bool insertPicture(const QString &path);

private:
    void buildTools(QVBoxLayout *layout);
    void buildColours(QVBoxLayout *layout);
    void placeWords(const Vec2 &at);
    void choosePicture();
    void refresh();

    StudioState &mState;
    DrawingHand &mHand;
    QButtonGroup *mTools;
    QButtonGroup *mColours;
    QLabel *mTitle;
    QLineEdit *mWords;
    QComboBox *mStickers;
    NumberSlider *mWidth;
    NumberSlider *mFilm;
    DrawingView *mView;
    FrameStrip *mStrip;
};

} // namespace ductus
