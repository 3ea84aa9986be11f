#include "widgets/pages/settings_dialog.h"

#include "widgets/theme/icons.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QListWidget>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace ductus {

SettingsDialog::SettingsDialog(QWidget *parent)
    : QDialog(parent), mList(new QListWidget), mPages(new QStackedWidget)
{
    setWindowTitle(tr("Settings"));
    setMinimumSize(760, 520);
    mList->setFixedWidth(176);
    mList->setIconSize({16, 16});
    mList->setAccessibleName(tr("Pages"));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->button(QDialogButtonBox::Close)->setAccessibleName(tr("Close"));
    buttons->button(QDialogButtonBox::Close)->setIcon({});
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(mList, &QListWidget::currentRowChanged, mPages, &QStackedWidget::setCurrentIndex);
    auto *row = new QHBoxLayout;
    row->setSpacing(24);
    row->addWidget(mList);
    row->addWidget(mPages, 1);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(16);
    layout->addLayout(row, 1);
    layout->addWidget(buttons);
}

void SettingsDialog::addPage(const QString &title, const QString &iconName, QWidget *page)
{
    auto *item = new QListWidgetItem(icon(iconName), title, mList);
    item->setSizeHint({160, 36});
    page->setAccessibleName(title);
    mPages->addWidget(page);
    if (mList->currentRow() < 0)
        mList->setCurrentRow(0);
}

void SettingsDialog::showPage(int index)
{
    mList->setCurrentRow(index);
}

int SettingsDialog::pageCount() const
{
    return mPages->count();
}

} // namespace ductus
