#include "widgets/controls/thin_bar.h"

#include "widgets/theme/theme.h"

#include <QPainter>
#include <algorithm>

namespace ductus {

ThinBar::ThinBar(QWidget *parent) : QWidget(parent)
{
    setFixedHeight(4);
}

void ThinBar::setFraction(double fraction)
{
    mFraction = std::clamp(fraction, 0.0, 1.0);
    update();
}

void ThinBar::paintEvent(QPaintEvent *)
{
    const ThemeColours colours = coloursOf(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(mixed(colours.line, colours.dim, 0.2));
    painter.drawRoundedRect(QRectF(rect()), 2.0, 2.0);
    painter.setBrush(colours.accent);
    painter.drawRoundedRect(QRectF(0.0, 0.0, width() * mFraction, height()), 2.0, 2.0);
}

} // namespace ductus
