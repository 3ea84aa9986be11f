#include "widgets/pages/shortcuts_page.h"

#include "document/settings/action_catalogue.h"
#include "widgets/shell/fuzzy_match.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace ductus {

namespace {

constexpr int idRole = Qt::UserRole;

QString keysText(const QList<QKeySequence> &keys)
{
    return QKeySequence::listToString(keys, QKeySequence::NativeText);
}

} // namespace

ShortcutsPage::ShortcutsPage(ActionCatalogue &actions, QWidget *parent)
    : QWidget(parent), mActions(actions), mFilter(new QLineEdit), mTree(new QTreeWidget),
      mKeys(new QKeySequenceEdit), mConflict(new QLabel),
      mTakeOver(new QPushButton(tr("&Use it here instead"))), mReset(new QPushButton(tr("&Default"))),
      mClear(new QPushButton(tr("&None")))
{
    mFilter->setPlaceholderText(tr("Filter by name or keys"));
    mFilter->setAccessibleName(tr("Filter by name or keys"));
    mFilter->setClearButtonEnabled(true);
    mTree->setAccessibleName(tr("Actions and their keys"));
    mTree->setColumnCount(2);
    mTree->setHeaderLabels({tr("Action"), tr("Keys")});
    mTree->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    mTree->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    mTree->header()->setStretchLastSection(false);
    mTree->setUniformRowHeights(true);
    mTree->setIconSize({16, 16});
    mKeys->setAccessibleName(tr("New keys"));
    mKeys->setToolTip(tr("Click here and press the new keys."));
    if (auto *field = mKeys->findChild<QLineEdit *>())
        field->setAccessibleName(tr("New keys"));
    mConflict->setWordWrap(true);
    mConflict->setAccessibleName(tr("Conflict"));
    mReset->setAccessibleName(tr("Default keys"));
    mClear->setAccessibleName(tr("No keys"));
    mTakeOver->setAccessibleName(tr("Use it here instead"));

    auto *edit = new QHBoxLayout;
    edit->setSpacing(8);
    auto *label = new QLabel(tr("&Keys"));
    label->setBuddy(mKeys);
    edit->addWidget(label);
    edit->addWidget(mKeys, 1);
    edit->addWidget(mClear);
    edit->addWidget(mReset);
    auto *conflict = new QHBoxLayout;
    conflict->setSpacing(8);
    conflict->addWidget(mConflict, 1);
    conflict->addWidget(mTakeOver);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(mFilter);
    layout->addWidget(mTree, 1);
    layout->addLayout(edit);
    layout->addLayout(conflict);

    connect(mFilter, &QLineEdit::textChanged, this, &ShortcutsPage::filter);
    connect(mTree, &QTreeWidget::currentItemChanged, this, &ShortcutsPage::showSelected);
    connect(mKeys, &QKeySequenceEdit::editingFinished, this, [this] { tryKeys(mKeys->keySequence()); });
    connect(mTakeOver, &QPushButton::clicked, this, [this] { assign(mWanted); });
    connect(mReset, &QPushButton::clicked, this, [this] {
        mActions.resetShortcuts(selectedId());
        showSelected();
    });
    connect(mClear, &QPushButton::clicked, this, [this] {
        mActions.setShortcuts(selectedId(), {});
        showSelected();
    });
    connect(&actions, &ActionCatalogue::shortcutsChanged, this, &ShortcutsPage::updateRow);
    fill();
}

void ShortcutsPage::fill()
{
    QHash<QString, QTreeWidgetItem *> categories;
    for (const QString &id : mActions.ids()) {
        const ActionSpec &spec = *mActions.spec(id);
        const QString category = spec.category.isEmpty() ? tr("Other") : spec.category;
        QTreeWidgetItem *&group = categories[category];
        if (!group) {
            group = new QTreeWidgetItem(mTree, {category});
            group->setFlags(Qt::ItemIsEnabled);
            group->setFirstColumnSpanned(true);
            QFont font = mTree->font();
            font.setWeight(QFont::DemiBold);
            group->setFont(0, font);
        }
        auto *row = new QTreeWidgetItem(group, {plainText(spec.text), keysText(mActions.shortcuts(id))});
        row->setIcon(0, mActions.action(id)->icon());
        row->setData(0, idRole, id);
        row->setToolTip(0, spec.teaches);
        updateRow(id);
    }
    mTree->expandAll();
    if (!mActions.ids().isEmpty())
        select(mActions.ids().first());
    showSelected();
}

void ShortcutsPage::filter(const QString &typed)
{
    for (int g = 0; g < mTree->topLevelItemCount(); ++g) {
        QTreeWidgetItem *group = mTree->topLevelItem(g);
        bool isAnyShown = false;
        for (int i = 0; i < group->childCount(); ++i) {
            QTreeWidgetItem *row = group->child(i);
            const bool isShown = fuzzyMatch(typed, row->text(0)).has_value() ||
                                 row->text(1).contains(typed.trimmed(), Qt::CaseInsensitive);
            row->setHidden(!isShown);
            isAnyShown |= isShown;
        }
        group->setHidden(!isAnyShown);
    }
}

QTreeWidgetItem *ShortcutsPage::rowOf(const QString &id) const
{
    for (int g = 0; g < mTree->topLevelItemCount(); ++g) {
        for (int i = 0; i < mTree->topLevelItem(g)->childCount(); ++i) {
            if (mTree->topLevelItem(g)->child(i)->data(0, idRole).toString() == id)
                return mTree->topLevelItem(g)->child(i);
        }
    }
    return nullptr;
}

void ShortcutsPage::select(const QString &id)
{
    if (QTreeWidgetItem *row = rowOf(id))
        mTree->setCurrentItem(row);
}

QString ShortcutsPage::selectedId() const
{
    const QTreeWidgetItem *row = mTree->currentItem();
    return row ? row->data(0, idRole).toString() : QString();
}

QString ShortcutsPage::conflictText() const
{
    return mConflict->text();
}

void ShortcutsPage::showSelected()
{
    const QString id = selectedId();
    const QList<QKeySequence> keys = mActions.shortcuts(id);
    mKeys->setKeySequence(keys.isEmpty() ? QKeySequence() : keys.first());
    mConflict->clear();
    mTakeOver->hide();
    mKeys->setEnabled(!id.isEmpty());
    mReset->setEnabled(mActions.hasOwnShortcuts(id));
    mClear->setEnabled(!keys.isEmpty());
}

void ShortcutsPage::tryKeys(const QKeySequence &keys)
{
    const QString id = selectedId();
    const QList<QKeySequence> present = mActions.shortcuts(id);
    if (id.isEmpty() || keys.isEmpty() || (!present.isEmpty() && present.first() == keys))
        return;
    const QStringList others = mActions.conflicts(id, keys);
    if (others.isEmpty()) {
        assign(keys);
        return;
    }
    QStringList names;
    for (const QString &other : others)
        names << plainText(mActions.spec(other)->text);
    mWanted = keys;
    mConflict->setText(tr("%1 is taken by: %2.")
                           .arg(keys.toString(QKeySequence::NativeText), names.join(QStringLiteral(", "))));
    mTakeOver->show();
}

void ShortcutsPage::assign(const QKeySequence &keys)
{
    const QString id = selectedId();
    for (const QString &other : mActions.conflicts(id, keys)) {
        QList<QKeySequence> left = mActions.shortcuts(other);
        left.removeIf([&](const QKeySequence &taken) {
            return taken.matches(keys) != QKeySequence::NoMatch ||
                   keys.matches(taken) != QKeySequence::NoMatch;
        });
        mActions.setShortcuts(other, left);
    }
    // The first is replaced, further ones (Redo has two) stay.
    QList<QKeySequence> own = mActions.shortcuts(id);
    if (own.isEmpty())
        own << keys;
    else
        own.first() = keys;
    mActions.setShortcuts(id, own);
    showSelected();
}

void ShortcutsPage::updateRow(const QString &id)
{
    QTreeWidgetItem *row = rowOf(id);
    if (!row)
        return;
    row->setText(1, keysText(mActions.shortcuts(id)));
    QFont font = mTree->font();
    font.setBold(mActions.hasOwnShortcuts(id)); // changed ones are found again at a glance
    row->setFont(1, font);
}

} // namespace ductus
