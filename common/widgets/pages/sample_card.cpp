#include "widgets/pages/sample_card.h"

#include "widgets/controls/elided_text.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"

#include <QImageReader>
#include <QPainter>
#include <QPainterPath>

namespace ductus {

namespace {

constexpr int pictureWidth = 240;
constexpr int pictureHeight = 150;
constexpr int margin = 12;
constexpr double radius = 8.0;

} // namespace

QImage coveringImage(const QImage &image, const QSize &size)
{
    if (image.isNull() || size.isEmpty())
        return {};
    const QImage scaled = image.scaled(size, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    const QPoint corner((scaled.width() - size.width()) / 2, (scaled.height() - size.height()) / 2);
    return scaled.copy(QRect(corner, size));
}

SampleCardButton::SampleCardButton(const SampleCard &card, QWidget *parent)
    : QAbstractButton(parent), mCard(card)
{
    setText(card.title);
    setAccessibleName(card.title);
    setAccessibleDescription(card.lesson);
    setToolTip(card.lesson);
    setCursor(Qt::PointingHandCursor);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    if (!card.picture.isEmpty()) {
        QImageReader reader(card.picture);
        reader.setAutoTransform(true);
        mPicture = reader.read(); // null when missing: the card then shows a mark
    }
}

QSize SampleCardButton::sizeHint() const
{
    const int line = fontMetrics().height();
    return {pictureWidth + 2, pictureHeight + 2 + margin + line + 4 + 2 * line + margin};
}

void SampleCardButton::paintEvent(QPaintEvent *)
{
    const ThemeColours colours = coloursOf(palette());
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    const QRectF box = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    QPainterPath shape;
    shape.addRoundedRect(box, radius, radius);
    painter.fillPath(shape, mIsHovered ? colours.hover : colours.raised);

    const QRect place(1, 1, width() - 2, pictureHeight);
    painter.save();
    painter.setClipPath(shape);
    if (mPicture.isNull()) {
        painter.fillRect(place, mixed(colours.window, colours.line, 0.5));
        ductus::icon(QStringLiteral("stroke"))
            .paint(&painter, QRect(place.center() - QPoint(24, 24), QSize(48, 48)), Qt::AlignCenter,
                   QIcon::Disabled);
    } else {
        const qreal scale = devicePixelRatioF();
        QImage image = coveringImage(mPicture, place.size() * scale);
        image.setDevicePixelRatio(scale);
        painter.drawImage(place.topLeft(), image);
    }
    painter.restore();
    const bool isMarked = hasFocus() || mIsHovered;
    painter.setPen(QPen(isMarked ? colours.accent : colours.line, hasFocus() ? 2.0 : 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(shape);

    const int line = fontMetrics().height();
    const QRect words = rect().adjusted(margin, pictureHeight + margin, -margin, -margin);
    painter.setFont(headingFont(font()));
    painter.setPen(colours.text);
    painter.drawText(QRect(words.left(), words.top(), words.width(), line), Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(mCard.title, Qt::ElideRight, words.width()));
    painter.setFont(font());
    painter.setPen(colours.dim);
    painter.drawText(QRect(words.left(), words.top() + line + 4, words.width(), 2 * line),
                     int(Qt::AlignLeft | Qt::AlignTop), elidedLines(mCard.lesson, font(), words.width(), 2));
}

void SampleCardButton::enterEvent(QEnterEvent *)
{
    mIsHovered = true;
    update();
}

void SampleCardButton::leaveEvent(QEvent *)
{
    mIsHovered = false;
    update();
}

} // namespace ductus
