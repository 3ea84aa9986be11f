#include "ui/gallery/gallery_canvas.h"

#include "widgets/theme/theme.h"

#include <QPainter>
#include <QPainterPath>
#include <cmath>

namespace ductus {

GalleryCanvas::GalleryCanvas(QWidget *parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(QStringLiteral("Canvas"));
    setMinimumSize(200, 200);
}

void GalleryCanvas::paintEvent(QPaintEvent *)
{
    const ThemeColours colours = coloursOf(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QLinearGradient ground(0, 0, 0, height());
    ground.setColorAt(0.0, mixed(colours.window, Qt::white, colours.isDark ? 0.08 : 0.4));
    ground.setColorAt(1.0, mixed(colours.window, Qt::black, colours.isDark ? 0.3 : 0.08));
    painter.fillRect(rect(), ground);
    painter.translate(width() / 2.0, height() / 2.0);
    const double size = std::min(width(), height()) * 0.36;
    for (int k = 0; k < 14; ++k) {
        QPainterPath path;
        for (int i = 0; i <= 80; ++i) {
            const double t = i / 80.0 * 6.2832;
            const double tilt = 0.25 + k * 0.05;
            const QPointF p(size * std::cos(t + k * 0.45) * (1.0 - 0.02 * k),
                            size * tilt * std::sin(t + k * 0.3) + (k - 7) * size * 0.07);
            i == 0 ? path.moveTo(p) : path.lineTo(p);
        }
        painter.setPen(QPen(mixed(colours.text, colours.window, 0.25), 1.6));
        painter.drawPath(path);
    }
}

} // namespace ductus
