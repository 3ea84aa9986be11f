// ScrubLabel: a label that is dragged sideways to change the number beside it.
#pragma once

#include <QLabel>

namespace ductus {

class ScrubLabel : public QLabel
{
    Q_OBJECT
public:
    explicit ScrubLabel(const QString &text, QWidget *parent = nullptr);

signals:
    void scrubBegun();
    /// Since the last one; a tenth with Shift.
    void scrubbed(double pixels);
    void scrubEnded();
    void resetRequested();

protected:
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;

private:
    double mPressX = 0.0;
    double mLastX = 0.0;
    bool mIsPressed = false;
    bool mIsScrubbing = false;
};

} // namespace ductus
