#include "widgets/pages/recent_row.h"

#include "widgets/pages/sample_card.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"

#include <QContextMenuEvent>
#include <QDir>
#include <QFileInfo>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>
#include <QPainterPath>

namespace ductus {

namespace {

constexpr int pictureSide = 40;

QString shortFolder(const QString &path)
{
    QString folder = QDir::toNativeSeparators(QFileInfo(path).absolutePath());
    if (folder.startsWith(QDir::homePath()))
        folder.replace(0, QDir::homePath().size(), QStringLiteral("~"));
    return folder;
}

} // namespace

RecentRow::RecentRow(const RecentCard &card, QWidget *parent) : QAbstractButton(parent), mCard(card)
{
    const QString name = QFileInfo(card.path).fileName();
    setText(name);
    setAccessibleName(card.isMissing ? tr("%1, missing").arg(name) : name);
    setAccessibleDescription(card.path);
    setToolTip(QDir::toNativeSeparators(card.path));
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(this, &QAbstractButton::clicked, this, [this] {
        if (!mCard.isMissing)
            emit opened(mCard.path);
    });
}

void RecentRow::paintEvent(QPaintEvent *)
{
    const ThemeColours colours = coloursOf(palette());
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    const QRectF box = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    if (mIsHovered || hasFocus()) {
        painter.setPen(hasFocus() ? QPen(colours.accent, 1.5) : QPen(Qt::NoPen));
        painter.setBrush(mIsHovered ? colours.hover : QColor(Qt::transparent));
        painter.drawRoundedRect(box, 6.0, 6.0);
    }
    const QRect place(8, (height() - pictureSide) / 2, pictureSide, pictureSide);
    QPainterPath shape;
    shape.addRoundedRect(place, 4.0, 4.0);
    painter.save();
    painter.setClipPath(shape);
    painter.fillRect(place, mixed(colours.window, colours.line, 0.6));
    if (!mCard.picture.isNull() && !mCard.isMissing) {
        const qreal scale = devicePixelRatioF();
        QImage image = coveringImage(mCard.picture.toImage(), place.size() * scale);
        image.setDevicePixelRatio(scale);
        painter.drawImage(place.topLeft(), image);
    } else {
        const QString mark = mCard.isMissing ? QStringLiteral("status-warning") : QStringLiteral("stroke");
        ductus::icon(mark).paint(&painter, place.adjusted(8, 8, -8, -8), Qt::AlignCenter, QIcon::Disabled);
    }
    painter.restore();

    const int x = place.right() + 13;
    const int line = fontMetrics().height();
    const int top = (height() - 2 * line - 2) / 2;
    const int textWidth = width() - x - 8;
    const QRect first(x, top, textWidth, line);
    const QRect second(x, top + line + 2, textWidth, line);
    painter.setPen(mCard.isMissing ? colours.dim : colours.text);
    painter.drawText(first, Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(text(), Qt::ElideMiddle, textWidth));
    painter.setPen(colours.dim);
    const QString below = mCard.isMissing ? tr("not there any more") : shortFolder(mCard.path);
    painter.drawText(second, Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(below, Qt::ElideMiddle, textWidth));
}

void RecentRow::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Delete)
        emit forgotten(mCard.path);
    else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        click();
    else
        QAbstractButton::keyPressEvent(event);
}

void RecentRow::contextMenuEvent(QContextMenuEvent *event)
{
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    QAction *open = menu->addAction(tr("&Open"), this, [this] { emit opened(mCard.path); });
    open->setEnabled(!mCard.isMissing);
    menu->addAction(tr("&Take off this list"), this, [this] { emit forgotten(mCard.path); });
    menu->popup(event->globalPos());
}

void RecentRow::enterEvent(QEnterEvent *)
{
    mIsHovered = true;
    update();
}

void RecentRow::leaveEvent(QEvent *)
{
    mIsHovered = false;
    update();
}

} // namespace ductus
