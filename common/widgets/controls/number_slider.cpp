#include "widgets/controls/number_slider.h"

#include "document/settings/action_catalogue.h"
#include "widgets/controls/scrub_label.h"
#include "widgets/controls/track_slider.h"
#include "widgets/theme/theme.h"

#include <QDoubleSpinBox>
#include <QEvent>
#include <QFocusEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double scrubPixels = 200.0; // of the mouse for the whole range

// The shares of a number in its range, and back: equal factors are equal ways on a logarithmic one.
double shareOf(double value, const NumberRange &range)
{
    if (range.isLogarithmic)
        return std::log(value / range.minimum) / std::log(range.maximum / range.minimum);
    return (value - range.minimum) / (range.maximum - range.minimum);
}

double valueAt(double share, const NumberRange &range)
{
    share = std::clamp(share, 0.0, 1.0);
    if (range.isLogarithmic)
        return range.minimum * std::pow(range.maximum / range.minimum, share);
    return range.minimum + (range.maximum - range.minimum) * share;
}

} // namespace

int decimalsFor(double size)
{
    return size > 0 && std::isfinite(size) ? std::clamp(int(std::ceil(2 - std::log10(size))), 0, 9) : 3;
}

NumberSlider::NumberSlider(const QString &label, const NumberRange &range, const QString &teaches,
                           QWidget *parent)
    : QWidget(parent), mRange(range), mLabel(new ScrubLabel(label)), mSlider(new TrackSlider),
      mField(new QDoubleSpinBox), mLow(new QLabel), mHigh(new QLabel)
{
    auto *layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setHorizontalSpacing(8);
    layout->setVerticalSpacing(4);
    layout->addWidget(mLabel, 0, 0, 1, 2);
    layout->addWidget(mField, 0, 2);
    layout->addWidget(mSlider, 1, 0, 1, 3);
    layout->addWidget(mLow, 2, 0);
    layout->addWidget(mHigh, 2, 2, Qt::AlignRight);
    layout->setColumnStretch(1, 1);
    for (QLabel *end : {mLow, mHigh}) {
        end->setProperty("dim", true);
        end->hide();
    }
    mSlider->setObjectName(QStringLiteral("track"));
    mField->setButtonSymbols(QAbstractSpinBox::NoButtons);
    mField->setKeyboardTracking(false); // a number half typed is no number
    mField->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    mField->setFixedWidth(88);
    mLabel->setBuddy(mField);
    setToolTip(teaches);
    setLabel(label);
    setRange(range);
    setValue(range.defaultValue);

    connect(mLabel, &ScrubLabel::scrubBegun, this, &NumberSlider::beginEdit);
    connect(mLabel, &ScrubLabel::scrubbed, this, [this](double pixels) {
        change(valueAt(shareOf(mValue, mRange) + pixels / scrubPixels, mRange));
    });
    connect(mLabel, &ScrubLabel::scrubEnded, this, &NumberSlider::endEdit);
    connect(mLabel, &ScrubLabel::resetRequested, this, &NumberSlider::reset);
    connect(mSlider, &TrackSlider::dragBegun, this, &NumberSlider::beginEdit);
    connect(mSlider, &TrackSlider::dragged, this,
            [this](double share) { change(rounded(valueAt(share, mRange))); });
    connect(mSlider, &TrackSlider::dragEnded, this, &NumberSlider::endEdit);
    connect(mSlider, &TrackSlider::resetRequested, this, &NumberSlider::reset);
    connect(mSlider, &TrackSlider::stepped, this, [this](int steps) {
        if (mRange.isLogarithmic) // a step is a fiftieth of the way
            editOnce(valueAt(shareOf(mValue, mRange) + steps / 50.0, mRange));
        else
            editOnce(mValue + steps * mRange.step);
    });
    connect(mSlider, &TrackSlider::endRequested, this,
            [this](bool high) { editOnce(high ? mRange.maximum : mRange.minimum); });
    connect(mField, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        if (!mIsShowing)
            editOnce(value);
    });
}

void NumberSlider::setRange(const NumberRange &range)
{
    mRange = range;
    mIsShowing = true;
    mField->setDecimals(range.decimals);
    mField->setRange(range.minimum, range.maximum);
    mField->setSingleStep(range.step);
    const bool isGlued = range.unit == QLatin1String("%") || range.unit == QString(QChar(0x00b0));
    mField->setSuffix(range.unit.isEmpty() ? QString()
                                           : (isGlued ? QString() : QString(QChar(0x202f))) + range.unit);
    mIsShowing = false;
    mSlider->setDefaultShare(shareOf(std::clamp(range.defaultValue, range.minimum, range.maximum), range));
    setValue(mValue);
}

void NumberSlider::setValue(double value)
{
    mValue = std::clamp(value, mRange.minimum, mRange.maximum);
    display(mValue);
}

QString NumberSlider::label() const
{
    return mLabel->text();
}

void NumberSlider::setLabel(const QString &label)
{
    mLabel->setText(label);
    const QString name = plainText(label);
    setAccessibleName(name);
    mSlider->setAccessibleName(name);
    mField->setAccessibleName(name);
    mSlider->setAccessibleDescription(toolTip());
    mField->setAccessibleDescription(toolTip());
}

void NumberSlider::setEnds(const QString &low, const QString &high)
{
    mLow->setText(low);
    mHigh->setText(high);
    mLow->setVisible(!low.isEmpty());
    mHigh->setVisible(!high.isEmpty());
}

void NumberSlider::reset()
{
    editOnce(mRange.defaultValue);
}

void NumberSlider::change(double value)
{
    value = std::clamp(value, mRange.minimum, mRange.maximum);
    if (value == mValue)
        return;
    mValue = value;
    display(value);
    emit valueChanged(value);
}

void NumberSlider::beginEdit()
{
    if (mOpenEdits++ == 0)
        emit editBegun();
}

void NumberSlider::endEdit()
{
    if (mOpenEdits > 0 && --mOpenEdits == 0) {
        change(rounded(mValue));
        emit editEnded();
    }
}

void NumberSlider::editOnce(double value)
{
    value = rounded(std::clamp(value, mRange.minimum, mRange.maximum));
    if (value == mValue)
        return;
    beginEdit();
    change(value);
    endEdit();
}

void NumberSlider::display(double value)
{
    mIsShowing = true;
    mField->setValue(value);
    mSlider->setShare(shareOf(value, mRange));
    mSlider->setValueText(mField->text());
    mIsShowing = false;
}

double NumberSlider::rounded(double value) const
{
    const double scale = std::pow(10.0, mRange.decimals);
    return std::clamp(std::round(value * scale) / scale, mRange.minimum, mRange.maximum);
}

// No focus proxy: Qt takes the whole for one stop of Tab then, and the field is never reached.
void NumberSlider::focusInEvent(QFocusEvent *event)
{
    mSlider->setFocus(event->reason());
}

void NumberSlider::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::ToolTipChange)
        setLabel(mLabel->text());
}

} // namespace ductus
