// NumberSlider: a number one can drag, type, scrub and reset, in one row: label, slider, field with unit.
//
// Drag on the label scrubs (Shift: ten times finer), double click on label or slider resets, arrow keys step,
// the field takes numbers with the comma or point of the user's language. Between editBegun() and editEnded()
// lie the values of one drag: one undo step. Typed values and steps come as a begin, one value, an end.
#pragma once

#include <QWidget>

class QDoubleSpinBox;
class QLabel;

namespace ductus {

class ScrubLabel;
class TrackSlider;

struct NumberRange
{
    double minimum = 0.0;
    double maximum = 1.0;
    double step = 0.01;        // of the arrow keys
    double defaultValue = 0.0; // of the double click
    int decimals = 2;
    QString unit = {};          // "mm", "%", "°"; shown after the number
    bool isLogarithmic = false; // equal ways of the slider are equal factors; minimum > 0
};

/// Decimals that show three digits of a number of about that size: lengths of small scenes and of large ones.
int decimalsFor(double size);

class NumberSlider : public QWidget
{
    Q_OBJECT
    Q_PROPERTY(double value READ value WRITE setValue NOTIFY valueChanged USER true)
public:
    /// \a label names the number in plain words and is its accessible name; \a teaches is the tooltip.
    NumberSlider(const QString &label, const NumberRange &range, const QString &teaches = {},
                 QWidget *parent = nullptr);

    double value() const { return mValue; }
    /// From the program: clamped, shown, no signal.
    void setValue(double value);
    const NumberRange &range() const { return mRange; }
    void setRange(const NumberRange &range);
    QString label() const;
    void setLabel(const QString &label);
    /// Words at the two ends of the slider ("loose", "tight"); empty: none.
    void setEnds(const QString &low, const QString &high);

signals:
    void editBegun();
    /// By the user; during a drag many times.
    void valueChanged(double value);
    void editEnded();

public slots:
    void reset();

protected:
    void changeEvent(QEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;

private:
    void change(double value);
    void beginEdit();
    void endEdit();
    void editOnce(double value);
    void display(double value);
    double rounded(double value) const;

    NumberRange mRange;
    double mValue = 0.0;
    int mOpenEdits = 0;
    bool mIsShowing = false;
    ScrubLabel *mLabel;
    TrackSlider *mSlider;
    QDoubleSpinBox *mField;
    QLabel *mLow;
    QLabel *mHigh;
};

} // namespace ductus
