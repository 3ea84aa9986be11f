// ActionLog: what the user did and when, if the user wants it written down. From it the timeline of
// operations of a user study is drawn (thesis Fig. VI.8). A line of JSON an act:
//
//     {"from": "2026-05-01T10:00:00.250Z", "until": "2026-05-01T10:00:02.125Z", "kind": "edit",
//      "action": "Pin canvas", "canvas": "Canvas 2", "frame": 20}
//
// kind: "edit" (a step of the history; a drag is one act), "undo", "redo", or "command" (an action that was
// chosen or whose key was pressed; action is its id). Frames count from 0.
#pragma once

#include "document/settings/action_catalogue.h"
#include "doodlestudio/document/doodle_document.h"

#include <QDateTime>
#include <functional>

namespace ductus {

/// What the user looked at.
struct LogPlace
{
    QString canvas; // its name; empty: none is chosen
    int frame = 0;
};

class ActionLog : public QObject
{
    Q_OBJECT
public:
    /// All must outlive this. \a place says where the user is; null: nowhere.
    ActionLog(DoodleDocument &document, ActionCatalogue &actions, std::function<LogPlace()> place,
              QObject *parent = nullptr);

    bool isOn() const { return mIsOn; }
    /// Turning it on begins a new log.
    void setOn(bool on);
    int length() const { return int(mActs.size()); }
    /// A line an act.
    QByteArray text() const;

private:
    struct Act
    {
        QDateTime from, until;
        QString kind, action;
        LogPlace place;
    };

    void onIndexChanged(int index);
    void watch(const QString &id);
    void note(const QString &kind, const QString &action);

    DoodleDocument &mDocument;
    ActionCatalogue &mActions;
    std::function<LogPlace()> mPlace;
    std::vector<Act> mActs;
    bool mIsOn = false;
    int mIndex = 0;
    const QUndoCommand *mUndone = nullptr; // the step that redo would bring back; never looked into
};

} // namespace ductus
