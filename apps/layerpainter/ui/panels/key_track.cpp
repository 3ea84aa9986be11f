#include "layerpainter/ui/panels/key_track.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double margin = 10;     // pixels left and right
constexpr double snapPixels = 5;  // keys draw the playhead
constexpr double sameTime = 1e-3; // seconds
constexpr double step = 1.0 / 25; // of the arrow keys, seconds

} // namespace

KeyTrack::KeyTrack(QWidget *parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Time"));
    setToolTip(tr("<b>Time</b><br>Drag to see the painting at another moment; diamonds are keys of the "
                  "camera (above) and of layers (below)."));
}

void KeyTrack::setLength(double seconds)
{
    mLength = std::max(seconds, 0.1);
    update();
}

void KeyTrack::setSeconds(double seconds)
{
    mSeconds = seconds;
    update();
}

void KeyTrack::setKeys(std::vector<TrackKey> keys)
{
    mKeys = std::move(keys);
    update();
}

bool KeyTrack::isOnCameraKey() const
{
    return std::ranges::any_of(mKeys, [&](const TrackKey &key) {
        return key.isCamera && std::abs(key.seconds - mSeconds) < sameTime;
    });
}

double KeyTrack::xAt(double seconds) const
{
    return margin + std::clamp(seconds / mLength, 0.0, 1.0) * (width() - 2 * margin);
}

void KeyTrack::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double middle = height() / 2.0;
    const QColor line = palette().color(QPalette::Mid), text = palette().color(QPalette::Text);
    const QColor accent = palette().color(QPalette::Highlight);
    painter.setPen(QPen(line, 2, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(margin, middle), QPointF(width() - margin, middle));
    painter.setPen(QPen(line, 1));
    double tick = 1; // seconds
    while (tick / mLength * (width() - 2 * margin) < 12)
        tick *= 5;
    for (double s = 0; s <= mLength + 1e-9; s += tick)
        painter.drawLine(QPointF(xAt(s), middle - 3), QPointF(xAt(s), middle + 3));
    painter.setPen(QPen(accent, 2, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(margin, middle), QPointF(xAt(mSeconds), middle));
    painter.setPen(Qt::NoPen);
    for (const TrackKey &key : mKeys) {
        const QPointF at(xAt(key.seconds), middle + (key.isCamera ? -7 : 7));
        QPainterPath diamond(at + QPointF(0, -4));
        diamond.lineTo(at + QPointF(4, 0));
        diamond.lineTo(at + QPointF(0, 4));
        diamond.lineTo(at + QPointF(-4, 0));
        painter.fillPath(diamond, key.isCamera ? accent : text);
    }
    painter.setPen(QPen(hasFocus() ? accent : text, 1.4));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(QRectF(xAt(mSeconds) - 4, middle - 9, 8, 18), 3, 3);
}

void KeyTrack::scrub(double seconds)
{
    seconds = std::clamp(seconds, 0.0, mLength);
    if (seconds == mSeconds)
        return;
    setSeconds(seconds);
    emit scrubbed(seconds);
}

void KeyTrack::scrubTo(double x)
{
    for (const TrackKey &key : mKeys)
        if (std::abs(xAt(key.seconds) - x) < snapPixels) {
            scrub(key.seconds);
            return;
        }
    scrub((x - margin) / std::max(1.0, width() - 2 * margin) * mLength);
}

void KeyTrack::mousePressEvent(QMouseEvent *event)
{
    scrubTo(event->position().x());
}

void KeyTrack::mouseMoveEvent(QMouseEvent *event)
{
    if (event->buttons() & Qt::LeftButton)
        scrubTo(event->position().x());
}

void KeyTrack::keyPressEvent(QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Left:
        scrub(mSeconds - step);
        break;
    case Qt::Key_Right:
        scrub(mSeconds + step);
        break;
    case Qt::Key_Home:
        scrub(0);
        break;
    case Qt::Key_End:
        scrub(mLength);
        break;
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace ductus
