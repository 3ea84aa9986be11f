#include "widgets/controls/segment_button.h"

#include "widgets/theme/theme.h"

#include <QPainter>
#include <QPainterPath>

namespace ductus {

namespace {

constexpr int buttonHeight = 28;
constexpr int iconSide = 16;
constexpr double radius = 6.0;

// A rectangle whose left and right corners are round or not.
QPainterPath bar(const QRectF &r, bool roundLeft, bool roundRight)
{
    const double left = roundLeft ? radius : 0.0;
    const double right = roundRight ? radius : 0.0;
    QPainterPath path;
    path.moveTo(r.left() + left, r.top());
    path.lineTo(r.right() - right, r.top());
    path.quadTo(r.right(), r.top(), r.right(), r.top() + right);
    path.lineTo(r.right(), r.bottom() - right);
    path.quadTo(r.right(), r.bottom(), r.right() - right, r.bottom());
    path.lineTo(r.left() + left, r.bottom());
    path.quadTo(r.left(), r.bottom(), r.left(), r.bottom() - left);
    path.lineTo(r.left(), r.top() + left);
    path.quadTo(r.left(), r.top(), r.left() + left, r.top());
    return path;
}

} // namespace

SegmentButton::SegmentButton(const QString &text, const QIcon &icon, QWidget *parent)
    : QAbstractButton(parent)
{
    setText(text);
    setIcon(icon);
    setCheckable(true);
}

void SegmentButton::setEnds(bool first, bool last)
{
    mIsFirst = first;
    mIsLast = last;
}

void SegmentButton::setComesBack(bool comesBack)
{
    mComesBack = comesBack;
    update();
}

QSize SegmentButton::sizeHint() const
{
    // As wide as in the heavier weight, so that choosing moves nothing.
    const QFontMetrics metrics(headingFont(font()));
    const int iconWidth = icon().isNull() ? 0 : iconSide + 6;
    return {metrics.horizontalAdvance(text()) + iconWidth + 28, buttonHeight};
}

void SegmentButton::paintEvent(QPaintEvent *)
{
    const ThemeColours colours = coloursOf(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool roundLeft = isRightToLeft() ? mIsLast : mIsFirst;
    const bool roundRight = isRightToLeft() ? mIsFirst : mIsLast;
    // The half pixel beyond an inner side lets neighbours share one line.
    const QRectF box(0.5, 0.5, width() - (roundRight ? 1.0 : 0.0), height() - 1.0);
    QColor ground = colours.isDark ? mixed(colours.window, Qt::black, 0.15) : colours.window;
    if (isChecked())
        ground = mixed(colours.panel, colours.accent, colours.isDark ? 0.32 : 0.22);
    else if (mIsHovered && isEnabled())
        ground = colours.hover;
    painter.setPen(QPen(colours.line, 1.0));
    painter.setBrush(ground);
    painter.drawPath(bar(box, roundLeft, roundRight));
    if (isChecked() || mComesBack) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(isChecked() ? colours.accent : colours.dim);
        painter.drawRoundedRect(QRectF(10.0, height() - 4.0, width() - 20.0, 2.0), 1.0, 1.0);
    }
    if (hasFocus()) {
        painter.setPen(QPen(colours.accent, 1.5));
        painter.setBrush(Qt::NoBrush);
        painter.drawPath(bar(box.adjusted(1.0, 1.0, -1.0, -1.0), roundLeft, roundRight));
    }

    painter.setFont(isChecked() ? headingFont(font()) : font());
    const int textWidth = painter.fontMetrics().horizontalAdvance(text());
    const int iconWidth = icon().isNull() ? 0 : iconSide + 6;
    int x = (width() - textWidth - iconWidth) / 2;
    if (iconWidth > 0) {
        icon().paint(&painter, QRect(x, (height() - iconSide) / 2, iconSide, iconSide), Qt::AlignCenter,
                     isEnabled() ? QIcon::Normal : QIcon::Disabled);
        x += iconWidth;
    }
    painter.setPen(isEnabled() ? (isChecked() || mIsHovered ? colours.text : colours.dim) : colours.disabled);
    painter.drawText(QRect(x, 0, textWidth + 2, height() - 1), int(Qt::AlignVCenter | Qt::TextShowMnemonic),
                     text());
}

void SegmentButton::enterEvent(QEnterEvent *)
{
    mIsHovered = true;
    update();
}

void SegmentButton::leaveEvent(QEvent *)
{
    mIsHovered = false;
    update();
}

} // namespace ductus
