// SegmentButton: one field of a SegmentedSwitch.
#pragma once

#include <QAbstractButton>

namespace ductus {

class SegmentButton : public QAbstractButton
{
    Q_OBJECT
public:
    SegmentButton(const QString &text, const QIcon &icon, QWidget *parent = nullptr);

    /// Whether its left and right ends are round.
    void setEnds(bool first, bool last);
    /// While another one is peeked at: this is the one to come back to.
    void setComesBack(bool comesBack);

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    void enterEvent(QEnterEvent *event) override;
    void leaveEvent(QEvent *event) override;

private:
    bool mIsFirst = false;
    bool mIsLast = false;
    bool mComesBack = false;
    bool mIsHovered = false;
};

} // namespace ductus
