#include "layerpainter/ui/panels/brush_panel.h"

#include "widgets/controls/number_slider.h"
#include "widgets/controls/segmented_switch.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <cmath>

namespace ductus {

BrushPanel::BrushPanel(BrushState &brush, QWidget *parent) : QWidget(parent), mBrush(brush)
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    mSize = new NumberSlider(tr("Size"), {0.001, 10, 0.01, 0.1, 3, {}, true},
                             tr("Half the width of a stroke in the painting's unit. Keys [ and ]."));
    layout->addWidget(mSize);
    auto *row = new QHBoxLayout;
    row->addWidget(new QLabel(tr("Section")));
    mSection = new QComboBox;
    mSection->setAccessibleName(tr("Section of strokes"));
    mSection->setToolTip(tr("The shape of a stroke cut across."));
    mSection->addItems({tr("Round"), tr("Ellipse"), tr("Square"), tr("Ribbon")}); // as StrokeSection
    row->addWidget(mSection, 1);
    layout->addLayout(row);
    mPlace = new SegmentedSwitch(
        tr("Where strokes go"),
        {{tr("On surface"), tr("Strokes lie on what is under the pointer.")},
         {tr("On plane"), tr("Strokes lie on a plane through the point the view turns around.")}},
        false);
    layout->addWidget(mPlace);
    connect(mSize, &NumberSlider::valueChanged, this, [this](double value) {
        mBrush.halfWidth = value;
        emit brushChanged();
    });
    connect(mSection, &QComboBox::activated, this, [this](int index) {
        mBrush.section = StrokeSection(index);
        emit brushChanged();
    });
    connect(mPlace, &SegmentedSwitch::currentChanged, this, [this](int index) {
        mBrush.onSurface = index == 0;
        emit brushChanged();
    });
}

void BrushPanel::setExtent(double diagonal)
{
    if (!(diagonal > 0))
        diagonal = 4;
    const double usual = 0.012 * diagonal;
    mSize->setRange({usual / 50, usual * 50, usual / 10, usual, decimalsFor(usual), {}, true});
    mSize->setValue(usual);
    mBrush.halfWidth = usual;
    emit brushChanged();
}

void BrushPanel::step(int steps)
{
    const double size = mBrush.halfWidth * std::pow(1.15, steps);
    mSize->setValue(size);
    mBrush.halfWidth = mSize->value();
    emit brushChanged();
}

} // namespace ductus
