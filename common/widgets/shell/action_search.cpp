#include "widgets/shell/action_search.h"

#include "document/settings/action_catalogue.h"
#include "widgets/shell/action_row_delegate.h"
#include "widgets/shell/fuzzy_match.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace ductus {

namespace {

constexpr int popupWidth = 520;
constexpr int rowHeight = 40;
constexpr int mostRows = 9;
constexpr int mostRecent = 6;

struct Hit
{
    QString id;
    FuzzyMatch match;
};

} // namespace

ActionSearch::ActionSearch(ActionCatalogue &actions, QWidget *parent)
    : QFrame(parent, Qt::Popup), mActions(actions), mField(new QLineEdit), mList(new QListWidget)
{
    setObjectName(QStringLiteral("searchPopup"));
    setAccessibleName(tr("Search actions"));
    setFixedWidth(popupWidth);
    mField->setPlaceholderText(tr("What do you want to do?"));
    mField->setAccessibleName(tr("Search actions"));
    mField->setClearButtonEnabled(true);
    mField->installEventFilter(this);
    mList->setAccessibleName(tr("Found actions"));
    mList->setFocusPolicy(Qt::NoFocus);
    mList->setItemDelegate(new ActionRowDelegate(mList));
    mList->setUniformItemSizes(true);
    mList->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(8);
    layout->addWidget(mField);
    layout->addWidget(mList);
    connect(mField, &QLineEdit::textChanged, this, &ActionSearch::refresh);
    connect(mField, &QLineEdit::returnPressed, this, &ActionSearch::runCurrent);
    connect(mList, &QListWidget::itemClicked, this, &ActionSearch::runCurrent);
}

void ActionSearch::openOver(const QWidget &window)
{
    mField->clear();
    refresh();
    move(window.mapToGlobal(QPoint((window.width() - width()) / 2, 52)));
    show();
    mField->setFocus(Qt::PopupFocusReason);
}

QStringList ActionSearch::shownIds() const
{
    QStringList ids;
    for (int i = 0; i < mList->count(); ++i)
        ids << mList->item(i)->data(ActionRowDelegate::IdRole).toString();
    return ids;
}

void ActionSearch::refresh()
{
    const QString typed = mField->text();
    std::vector<Hit> hits;
    for (const QString &id : mActions.ids()) {
        const QAction *action = mActions.action(id);
        if (!action->isVisible() || id == QLatin1String("help.search"))
            continue;
        const ActionSpec &spec = *mActions.spec(id);
        const QString name = plainText(spec.text);
        if (const auto match = fuzzyMatch(typed, name)) {
            hits.push_back({id, *match});
        } else if (const auto inCategory = fuzzyMatch(typed, spec.category + QLatin1Char(' ') + name)) {
            hits.push_back({id, FuzzyMatch{inCategory->score - 20, {}}});
        }
    }
    const auto rank = [&](const Hit &hit) {
        const qsizetype recent = mRecent.indexOf(hit.id);
        const int bonus = recent < 0 ? 0 : (typed.trimmed().isEmpty() ? 1000 : 6) - int(recent);
        const int late = typed.trimmed().isEmpty() && mLast.contains(hit.id) ? 40 : 0;
        return hit.match.score + bonus - late - (mActions.action(hit.id)->isEnabled() ? 0 : 15);
    };
    std::stable_sort(hits.begin(), hits.end(), [&](const Hit &a, const Hit &b) { return rank(a) > rank(b); });

    mList->clear();
    for (const Hit &hit : hits) {
        const ActionSpec &spec = *mActions.spec(hit.id);
        QAction *action = mActions.action(hit.id);
        auto *item = new QListWidgetItem(action->icon(), plainText(spec.text), mList);
        item->setSizeHint({popupWidth - 32, rowHeight});
        item->setData(ActionRowDelegate::IdRole, hit.id);
        item->setData(ActionRowDelegate::TeachesRole, spec.teaches);
        item->setData(ActionRowDelegate::KeysRole, action->shortcut().toString(QKeySequence::NativeText));
        item->setData(ActionRowDelegate::PositionsRole, QVariant::fromValue(hit.match.positions));
        if (!action->isEnabled())
            item->setFlags(Qt::ItemIsSelectable);
    }
    if (mList->count() == 0) {
        auto *item = new QListWidgetItem(tr("Nothing is called like that."), mList);
        item->setFlags(Qt::NoItemFlags);
        item->setSizeHint({popupWidth - 32, rowHeight});
    }
    mList->setCurrentRow(0);
    mList->setFixedHeight(std::min(mList->count(), mostRows) * rowHeight + 2);
    adjustSize();
}

void ActionSearch::runCurrent()
{
    const QListWidgetItem *item = mList->currentItem();
    if (!item)
        return;
    const QString id = item->data(ActionRowDelegate::IdRole).toString();
    QAction *action = mActions.action(id);
    if (!action || !action->isEnabled())
        return;
    mRecent.removeAll(id);
    mRecent.prepend(id);
    if (mRecent.size() > mostRecent)
        mRecent.removeLast();
    close(); // before the action, which may open a window of its own
    action->trigger();
}

bool ActionSearch::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == mField && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent *>(event)->key();
        int step = 0;
        if (key == Qt::Key_Down)
            step = 1;
        else if (key == Qt::Key_Up)
            step = -1;
        else if (key == Qt::Key_PageDown)
            step = mostRows;
        else if (key == Qt::Key_PageUp)
            step = -mostRows;
        if (step != 0) {
            mList->setCurrentRow(std::clamp(mList->currentRow() + step, 0, mList->count() - 1));
            return true;
        }
    }
    return QFrame::eventFilter(watched, event);
}

} // namespace ductus
