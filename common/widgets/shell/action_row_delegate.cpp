#include "widgets/shell/action_row_delegate.h"

#include "widgets/theme/theme.h"

#include <QIcon>
#include <QPainter>

namespace ductus {

namespace {

constexpr int iconSide = 16;
constexpr int margin = 12;

// Draws \a text with the letters at \a positions heavier and in the accent's colour; returns where it ends.
int drawMarked(QPainter &painter, int x, const QRect &row, const QString &text, const QList<int> &positions,
               const QColor &plain, const QColor &marked)
{
    const QFont base = painter.font();
    const QFont heavy = headingFont(base);
    qsizetype i = 0;
    while (i < text.size()) {
        const bool isMarked = positions.contains(int(i));
        qsizetype end = i;
        while (end < text.size() && positions.contains(int(end)) == isMarked)
            ++end;
        const QString piece = text.mid(i, end - i);
        painter.setFont(isMarked ? heavy : base);
        painter.setPen(isMarked ? marked : plain);
        painter.drawText(QRect(x, row.top(), row.width(), row.height()), Qt::AlignVCenter | Qt::AlignLeft,
                         piece);
        x += painter.fontMetrics().horizontalAdvance(piece);
        i = end;
    }
    painter.setFont(base);
    return x;
}

} // namespace

void ActionRowDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option,
                              const QModelIndex &index) const
{
    const ThemeColours colours = coloursOf(option.palette);
    const bool isSelected = option.state.testFlag(QStyle::State_Selected);
    const bool isEnabled = index.flags().testFlag(Qt::ItemIsEnabled);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setFont(option.font);
    if (isSelected) {
        painter->setPen(Qt::NoPen);
        painter->setBrush(option.palette.color(QPalette::Highlight));
        painter->drawRoundedRect(QRectF(option.rect).adjusted(0, 1, 0, -1), 6.0, 6.0);
    }
    const QRect row = option.rect.adjusted(margin, 0, -margin, 0);
    const QIcon picture = index.data(Qt::DecorationRole).value<QIcon>();
    picture.paint(painter, QRect(row.left(), row.center().y() - iconSide / 2 + 1, iconSide, iconSide),
                  Qt::AlignCenter, isEnabled ? QIcon::Normal : QIcon::Disabled);

    const QString keys = index.data(KeysRole).toString();
    const int keysWidth = keys.isEmpty() ? 0 : painter->fontMetrics().horizontalAdvance(keys) + margin;
    const QColor plain = isEnabled ? colours.text : colours.disabled;
    int x = row.left() + iconSide + margin;
    x = drawMarked(*painter, x, row, index.data(Qt::DisplayRole).toString(),
                   index.data(PositionsRole).value<QList<int>>(), plain,
                   isEnabled ? colours.accentText : plain);
    painter->setPen(isEnabled ? colours.dim : colours.disabled);
    const QRect rest(x + margin, row.top(), row.right() - keysWidth - x - margin, row.height());
    if (rest.width() > 40)
        painter->drawText(rest, Qt::AlignVCenter | Qt::AlignLeft,
                          painter->fontMetrics().elidedText(index.data(TeachesRole).toString(),
                                                            Qt::ElideRight, rest.width()));
    painter->drawText(row, Qt::AlignVCenter | Qt::AlignRight, keys);
    painter->restore();
}

} // namespace ductus
