#include "widgets/pages/pressure_test_field.h"

#include "widgets/theme/theme.h"

#include <QMouseEvent>
#include <QPainter>
#include <QTabletEvent>

namespace ductus {

namespace {

constexpr double widestPixels = 24.0;
constexpr double mousePressure = 0.5; // a mouse has none; the middle shows what the curve does there
constexpr qsizetype mostDots = 20000;

} // namespace

PressureTestField::PressureTestField(QWidget *parent) : QWidget(parent)
{
    setAccessibleName(tr("Test field for the pen"));
    setCursor(Qt::CrossCursor);
    setMinimumSize(200, 200);
    setAttribute(Qt::WA_TabletTracking, false);
}

void PressureTestField::clear()
{
    mStrokes.clear();
    update();
}

void PressureTestField::add(QPointF position, double pressure, bool isFirst)
{
    mStrokes.append({position, pressure, isFirst});
    if (mStrokes.size() > mostDots)
        mStrokes.remove(0, mostDots / 2);
    emit pressureChanged(pressure);
    update();
}

void PressureTestField::tabletEvent(QTabletEvent *event)
{
    event->accept();
    if (event->pointerType() == QPointingDevice::PointerType::Eraser) {
        clear();
        return;
    }
    if (event->type() == QEvent::TabletRelease)
        emit pressureChanged(-1.0);
    else if (event->buttons().testFlag(Qt::LeftButton))
        add(event->position(), event->pressure(), event->type() == QEvent::TabletPress);
}

void PressureTestField::mousePressEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        add(event->position(), mousePressure, true);
}

void PressureTestField::mouseMoveEvent(QMouseEvent *event)
{
    if (event->buttons().testFlag(Qt::LeftButton))
        add(event->position(), mousePressure, mStrokes.isEmpty());
}

void PressureTestField::mouseReleaseEvent(QMouseEvent *)
{
    emit pressureChanged(-1.0);
}

void PressureTestField::paintEvent(QPaintEvent *)
{
    const ThemeColours colours = coloursOf(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colours.line, 1.0));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6.0, 6.0);
    if (mStrokes.isEmpty()) {
        painter.setPen(colours.dim);
        painter.drawText(rect().adjusted(24, 24, -24, -24), int(Qt::AlignCenter | Qt::TextWordWrap),
                         tr("Draw here with your pen to try the curve."));
        return;
    }
    painter.setClipRect(rect().adjusted(1, 1, -1, -1));
    for (qsizetype i = 0; i < mStrokes.size(); ++i) {
        const Dot &dot = mStrokes[i];
        const QPointF before = dot.isFirst || i == 0 ? dot.position : mStrokes[i - 1].position;
        painter.setPen(QPen(colours.text, std::max(0.5, mCurve.map(dot.pressure) * widestPixels),
                            Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(before, dot.position);
    }
}

} // namespace ductus
