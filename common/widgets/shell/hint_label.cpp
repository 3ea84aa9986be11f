#include "widgets/shell/hint_label.h"

#include "widgets/theme/theme.h"

#include <QPainter>

namespace ductus {

HintLabel::HintLabel(QWidget *parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

void HintLabel::setText(const QString &text)
{
    mText = text;
    setToolTip(text);
    setAccessibleName(text);
    updateGeometry();
    update();
}

QSize HintLabel::sizeHint() const
{
    return {fontMetrics().horizontalAdvance(mText), fontMetrics().height()};
}

void HintLabel::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setPen(coloursOf(palette()).dim);
    painter.drawText(rect(), Qt::AlignVCenter | Qt::AlignLeft,
                     fontMetrics().elidedText(mText, Qt::ElideRight, width()));
}

} // namespace ductus
