// HintLabel: one line that is cut with dots where there is no room, with the whole in its tooltip.
#pragma once

#include <QWidget>

namespace ductus {

class HintLabel : public QWidget
{
    Q_OBJECT
public:
    explicit HintLabel(QWidget *parent = nullptr);
    QString text() const { return mText; }
    void setText(const QString &text);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {0, fontMetrics().height()}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QString mText;
};

} // namespace ductus
