#include "doodlestudio/document/action_log.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QUndoStack>
#include <utility>

namespace ductus {

ActionLog::ActionLog(DoodleDocument &document, ActionCatalogue &actions, std::function<LogPlace()> place,
                     QObject *parent)
    : QObject(parent), mDocument(document), mActions(actions), mPlace(std::move(place))
{
    connect(document.undoStack(), &QUndoStack::indexChanged, this, &ActionLog::onIndexChanged);
    connect(&actions, &ActionCatalogue::added, this, &ActionLog::watch);
    for (const QString &id : actions.ids())
        watch(id);
}

void ActionLog::setOn(bool on)
{
    if (on && !mIsOn)
        mActs.clear();
    mIsOn = on;
    mIndex = mDocument.undoStack()->index();
    mUndone = mIndex < mDocument.undoStack()->count() ? mDocument.undoStack()->command(mIndex) : nullptr;
}

void ActionLog::watch(const QString &id)
{
    connect(mActions.action(id), &QAction::triggered, this,
            [this, id] { note(QStringLiteral("command"), id); });
}

void ActionLog::onIndexChanged(int index)
{
    const QUndoStack &stack = *mDocument.undoStack();
    const int before = std::exchange(mIndex, index);
    if (!mIsOn || stack.count() == 0)
        return;
    if (index < before) {
        for (int i = before; i > index; --i)
            note(QStringLiteral("undo"), stack.text(i - 1));
        mUndone = stack.command(index);
        return;
    }
    // A drag goes on: the stack made its step and the one before it one.
    if (index == before) {
        if (!mActs.empty() && mActs.back().kind == QLatin1String("edit"))
            mActs.back().until = QDateTime::currentDateTimeUtc();
        return;
    }
    // A step brought back is the very one that stood there; a new one has taken its place.
    const bool isRedo = mUndone && stack.command(before) == mUndone;
    for (int i = before; i < index; ++i)
        note(isRedo ? QStringLiteral("redo") : QStringLiteral("edit"), stack.text(i));
    mUndone = index < stack.count() ? stack.command(index) : nullptr;
}

void ActionLog::note(const QString &kind, const QString &action)
{
    if (!mIsOn)
        return;
    const QDateTime now = QDateTime::currentDateTimeUtc();
    mActs.push_back({now, now, kind, action, mPlace ? mPlace() : LogPlace()});
}

QByteArray ActionLog::text() const
{
    QByteArray lines;
    for (const Act &act : mActs) {
        QJsonObject line{{QStringLiteral("from"), act.from.toString(Qt::ISODateWithMs)},
                         {QStringLiteral("until"), act.until.toString(Qt::ISODateWithMs)},
                         {QStringLiteral("kind"), act.kind},
                         {QStringLiteral("action"), act.action},
                         {QStringLiteral("frame"), act.place.frame}};
        if (!act.place.canvas.isEmpty())
            line[QStringLiteral("canvas")] = act.place.canvas;
        lines += QJsonDocument(line).toJson(QJsonDocument::Compact) + '\n';
    }
    return lines;
}

} // namespace ductus
