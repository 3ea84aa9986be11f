// TrackSlider: a calm horizontal slider of shares 0..1: a thin track, filled from its left end, with a tick
// at the default. A click anywhere jumps there, dragging follows, arrow keys step.
#pragma once

#include <QWidget>

namespace ductus {

class TrackSlider : public QWidget
{
    Q_OBJECT
public:
    explicit TrackSlider(QWidget *parent = nullptr);

    double share() const { return mShare; }
    void setShare(double share);
    /// Where the tick is; negative: none.
    void setDefaultShare(double share);
    /// What screen readers say the value is.
    void setValueText(const QString &text);
    QString valueText() const { return mValueText; }

    QSize sizeHint() const override { return {120, 20}; }
    QSize minimumSizeHint() const override { return {48, 20}; }

signals:
    void dragBegun();
    void dragged(double share);
    void dragEnded();
    void stepped(int steps);
    void endRequested(bool high);
    void resetRequested();

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void enterEvent(QEnterEvent *event) override;
    void leaveEvent(QEvent *event) override;

private:
    double shareAt(double x) const;
    double xAt(double share) const;

    double mShare = 0.0;
    double mDefaultShare = -1.0;
    QString mValueText;
    bool mIsDragging = false;
    bool mIsHovered = false;
};

} // namespace ductus
