#include "document/settings/action_catalogue.h"

#include "base/assert.h"

namespace ductus {

namespace {

const QString section = QStringLiteral("shortcuts");

QString keyOf(const QString &id)
{
    return section + QLatin1Char('/') + id;
}

bool canMeet(const QString &modeA, const QString &modeB)
{
    return modeA.isEmpty() || modeB.isEmpty() || modeA == modeB;
}

// Without the one empty sequence Qt makes of an empty text.
QList<QKeySequence> sequencesFrom(const QString &text)
{
    QList<QKeySequence> sequences = QKeySequence::listFromString(text, QKeySequence::PortableText);
    sequences.removeIf([](const QKeySequence &sequence) { return sequence.isEmpty(); });
    return sequences;
}

} // namespace

QString plainText(const QString &actionText)
{
    QString text;
    for (qsizetype i = 0; i < actionText.size(); ++i) {
        // Where no letter of a word can be pressed, as in Japanese, the key stands behind: "開く(&O)...".
        if (actionText[i] == QLatin1Char('(') && i + 3 < actionText.size() &&
            actionText[i + 1] == QLatin1Char('&') && actionText[i + 3] == QLatin1Char(')')) {
            i += 3;
            continue;
        }
        if (actionText[i] == QLatin1Char('&') && i + 1 < actionText.size())
            ++i;
        text += actionText[i];
    }
    while (text.endsWith(QLatin1Char('.')) || text.endsWith(QChar(0x2026)))
        text.chop(1);
    return text;
}

ActionCatalogue::ActionCatalogue(Settings *settings, QObject *parent) : QObject(parent), mSettings(settings)
{
}

QAction *ActionCatalogue::add(const ActionSpec &spec, std::function<void()> run)
{
    DUCTUS_ASSERT(!spec.id.isEmpty() && !mEntries.contains(spec.id));
    Entry entry{spec, new QAction(spec.text, this), {}};
    entry.action->setObjectName(spec.id);
    entry.action->setCheckable(spec.isCheckable);
    entry.action->setShortcutContext(spec.context);
    entry.action->setStatusTip(spec.teaches);
    if (run)
        connect(entry.action, &QAction::triggered, this, [run = std::move(run)] { run(); });
    applyShortcuts(entry);
    mEntries.insert(spec.id, entry);
    mOrder.append(spec.id);
    emit added(spec.id);
    return entry.action;
}

QAction *ActionCatalogue::addToggle(const ActionSpec &spec, std::function<void(bool)> run)
{
    ActionSpec checkable = spec;
    checkable.isCheckable = true;
    QAction *action = add(checkable);
    if (run)
        connect(action, &QAction::toggled, this, [run = std::move(run)](bool on) { run(on); });
    return action;
}

QAction *ActionCatalogue::action(const QString &id) const
{
    const auto found = mEntries.find(id);
    return found == mEntries.end() ? nullptr : found->action;
}

const ActionSpec *ActionCatalogue::spec(const QString &id) const
{
    const auto found = mEntries.find(id);
    return found == mEntries.end() ? nullptr : &found->spec;
}

const ActionSpec *ActionCatalogue::spec(const QAction *action) const
{
    return action && action->parent() == this ? spec(action->objectName()) : nullptr;
}

QList<QKeySequence> ActionCatalogue::shortcuts(const QString &id) const
{
    const QAction *found = action(id);
    return found ? found->shortcuts() : QList<QKeySequence>();
}

bool ActionCatalogue::hasOwnShortcuts(const QString &id) const
{
    return mSettings && mSettings->raw(keyOf(id)).isValid();
}

void ActionCatalogue::setShortcuts(const QString &id, const QList<QKeySequence> &shortcuts)
{
    const auto found = mEntries.find(id);
    if (found == mEntries.end())
        return;
    if (mSettings) {
        if (shortcuts == found->spec.shortcuts)
            mSettings->remove(keyOf(id));
        else
            mSettings->setRaw(keyOf(id), QKeySequence::listToString(shortcuts, QKeySequence::PortableText));
    }
    found->action->setShortcuts(shortcuts);
    updateToolTip(*found);
    emit shortcutsChanged(id);
}

void ActionCatalogue::resetShortcuts(const QString &id)
{
    if (const ActionSpec *known = spec(id))
        setShortcuts(id, QList<QKeySequence>(known->shortcuts));
}

void ActionCatalogue::resetAllShortcuts()
{
    for (const QString &id : std::as_const(mOrder))
        resetShortcuts(id);
}

QStringList ActionCatalogue::conflicts(const QString &id, const QKeySequence &shortcut) const
{
    QStringList others;
    const ActionSpec *own = spec(id);
    if (!own || shortcut.isEmpty())
        return others;
    for (const QString &other : mOrder) {
        const Entry &entry = *mEntries.find(other);
        if (other == id || !canMeet(own->mode, entry.spec.mode))
            continue;
        for (const QKeySequence &taken : entry.action->shortcuts()) {
            // A sequence that begins with another one can never be finished.
            if (taken.matches(shortcut) != QKeySequence::NoMatch ||
                shortcut.matches(taken) != QKeySequence::NoMatch) {
                others << other;
                break;
            }
        }
    }
    return others;
}

void ActionCatalogue::setDisabledReason(const QString &id, const QString &reason)
{
    const auto found = mEntries.find(id);
    if (found == mEntries.end())
        return;
    found->disabledReason = reason;
    found->action->setEnabled(reason.isEmpty());
    updateToolTip(*found);
}

void ActionCatalogue::applyShortcuts(Entry &entry)
{
    const QVariant own = mSettings ? mSettings->raw(keyOf(entry.spec.id)) : QVariant();
    entry.action->setShortcuts(own.isValid() ? sequencesFrom(own.toString()) : entry.spec.shortcuts);
    updateToolTip(entry);
}

void ActionCatalogue::updateToolTip(Entry &entry)
{
    QString head = QStringLiteral("<b>%1</b>").arg(plainText(entry.spec.text).toHtmlEscaped());
    const QString keys = entry.action->shortcut().toString(QKeySequence::NativeText);
    if (!keys.isEmpty())
        head += QStringLiteral("&nbsp;&nbsp;<span style='font-weight:normal'>%1</span>")
                    .arg(keys.toHtmlEscaped());
    QString tip = QStringLiteral("<p style='margin:0'>%1</p>").arg(head);
    if (!entry.spec.teaches.isEmpty())
        tip += QStringLiteral("<p style='margin:4px 0 0 0'>%1</p>").arg(entry.spec.teaches.toHtmlEscaped());
    if (!entry.disabledReason.isEmpty())
        tip += QStringLiteral("<p style='margin:4px 0 0 0'><i>%1</i></p>")
                   .arg(entry.disabledReason.toHtmlEscaped());
    entry.action->setToolTip(tip);
}

} // namespace ductus
