// ActionRowDelegate: a row of the action search: icon, name with the typed letters marked, sentence, keys.
#pragma once

#include <QStyledItemDelegate>

namespace ductus {

class ActionRowDelegate : public QStyledItemDelegate
{
    Q_OBJECT
public:
    enum Role { IdRole = Qt::UserRole, TeachesRole, KeysRole, PositionsRole };

    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
};

} // namespace ductus
