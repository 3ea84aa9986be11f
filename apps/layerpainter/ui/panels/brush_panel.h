// BrushPanel: size, section and place of the next stroke.
#pragma once

#include "layerpainter/ui/tools/painter_tools.h"

class QComboBox;

namespace ductus {

class NumberSlider;
class SegmentedSwitch;

class BrushPanel : public QWidget
{
    Q_OBJECT
public:
    explicit BrushPanel(BrushState &brush, QWidget *parent = nullptr);

    /// The sizes offered fit a painting of this diagonal, scene units.
    void setExtent(double diagonal);
    /// Larger or smaller by a step.
    void step(int steps);

signals:
    void brushChanged();

private:
    BrushState &mBrush;
    NumberSlider *mSize;
    QComboBox *mSection;
    SegmentedSwitch *mPlace;
};

} // namespace ductus
