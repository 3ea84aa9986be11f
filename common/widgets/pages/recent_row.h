// RecentRow: a recent file: a small picture, its name, its folder. A missing one is greyed and says so; it
// can be taken off the list.
#pragma once

#include "widgets/pages/start_page.h"

#include <QAbstractButton>

namespace ductus {

class RecentRow : public QAbstractButton
{
    Q_OBJECT
public:
    explicit RecentRow(const RecentCard &card, QWidget *parent = nullptr);
    QSize sizeHint() const override { return {280, 56}; }

signals:
    void opened(const QString &path);
    void forgotten(const QString &path);

protected:
    void paintEvent(QPaintEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;
    void enterEvent(QEnterEvent *event) override;
    void leaveEvent(QEvent *event) override;

private:
    RecentCard mCard;
    bool mIsHovered = false;
};

} // namespace ductus
