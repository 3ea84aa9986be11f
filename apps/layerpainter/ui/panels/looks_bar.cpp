#include "layerpainter/ui/panels/looks_bar.h"

#include "widgets/theme/icons.h"

#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QToolButton>

namespace ductus {

LooksBar::LooksBar(PaintingDocument &document, QWidget *parent) : QWidget(parent), mDocument(document)
{
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 6, 12, 6);
    layout->setSpacing(8);
    auto *label = new QLabel(tr("Looks"));
    QFont bold = label->font();
    bold.setWeight(QFont::DemiBold);
    label->setFont(bold);
    layout->addWidget(label);
    mChips = new QHBoxLayout;
    mChips->setSpacing(6);
    layout->addLayout(mChips);
    auto *add = new QToolButton;
    add->setIcon(icon(QStringLiteral("list-add")));
    add->setAccessibleName(tr("Keep this look"));
    add->setToolTip(
        tr("<b>Keep this look</b><br>Remembers what all layers are now: visible, how strong, how mixed."));
    connect(add, &QToolButton::clicked, this, &LooksBar::addLook);
    layout->addWidget(add);
    layout->addStretch();
    connect(&mDocument, &Document::changed, this, [this](const ChangeEvent &event) {
        const auto *change = event.as<PaintingChanged>();
        // Whatever else changes the layers' properties leaves the look.
        if (!change || (change->properties && !mIsSwitching))
            mCurrent.reset();
        if (!change || change->looks || change->properties)
            refresh();
    });
    refresh();
}

void LooksBar::addLook()
{
    const auto made = mDocument.perform(
        act::AddLook{tr("Look %1").arg(mDocument.painting().looks.size() + 1).toStdString()});
    if (made) {
        mCurrent = LookId{made->front()};
        refresh();
    }
}

void LooksBar::refresh()
{
    while (QLayoutItem *item = mChips->takeAt(0)) {
        if (item->widget())
            item->widget()->deleteLater();
        delete item;
    }
    for (const Look &look : mDocument.painting().looks) {
        auto *chip = new QToolButton;
        chip->setText(QString::fromStdString(look.name));
        chip->setMinimumHeight(28);
        chip->setMinimumWidth(72);
        chip->setCheckable(true);
        chip->setChecked(mCurrent == look.id);
        chip->setToolTip(tr("Shows this look; right click to update, rename or delete it."));
        chip->setContextMenuPolicy(Qt::CustomContextMenu);
        connect(chip, &QToolButton::clicked, this, [this, id = look.id] {
            mIsSwitching = true;
            mCurrent = id;
            (void)mDocument.perform(act::ApplyLook{id});
            mIsSwitching = false;
        });
        connect(chip, &QToolButton::customContextMenuRequested, this,
                [this, id = look.id, chip](const QPoint &at) { showMenu(id, chip->mapToGlobal(at)); });
        mChips->addWidget(chip);
    }
}

void LooksBar::showMenu(LookId look, const QPoint &at)
{
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Update from the present"), this,
                    [this, look] { (void)mDocument.perform(act::UpdateLook{look}); });
    menu->addAction(tr("Rename..."), this, [this, look] {
        const Look *found = mDocument.painting().findLook(look);
        const QString name = QInputDialog::getText(this, tr("Rename look"), tr("Name"), QLineEdit::Normal,
                                                   found ? QString::fromStdString(found->name) : QString());
        if (!name.trimmed().isEmpty())
            (void)mDocument.perform(act::RenameLook{look, name.trimmed().toStdString()});
    });
    menu->addAction(tr("Delete"), this, [this, look] { (void)mDocument.perform(act::RemoveLook{look}); });
    menu->popup(at);
}

} // namespace ductus
