// PaintingDocument: one painting with its history and the log of everything the painter did. Every edit is an
// action (painting/action), so the log can be played again and gives the same painting.
#pragma once

#include "document/document.h"
#include "painting/action/action_log.h"
#include "painting/storage/painting_content.h"

#include <QImage>

namespace ductus {

/// What of the painting is another.
struct PaintingChanged : ChangeEvent
{
    bool elements = false;   // strokes: which there are, where, how they look
    bool layers = false;     // stacks and layers: which there are, order, names, locks
    bool properties = false; // visibility, opacity, blend modes, masks, tolerance
    bool looks = false;
    bool scene = false; // background, camera, motion
};

class PaintingDocument : public Document
{
    Q_OBJECT
public:
    explicit PaintingDocument(QObject *parent = nullptr);

    const Painting &painting() const { return *mPainting; }
    /// For workers and views; never null.
    std::shared_ptr<const Painting> sharedPainting() const { return mPainting; }
    bool isEmpty() const { return mPainting->stacks.empty(); }
    /// The project that was opened holds no painting: its surfaces were taken, and nothing is saved yet.
    bool isMadeOfSurfaces() const { return mIsMadeOfSurfaces; }

    /// A new, unsaved document; history and log begin here. \a source: the file the painting was read from,
    /// for the log; empty for an empty painting.
    void start(Painting painting, const QString &name, const QString &source = {});

    /// Does \a action as one step of the history; the ids of what is new. Refused actions change nothing.
    /// Actions of the same kind and \a drag (> 0) become one step: the last one counts, so each must say all
    /// of it (an opacity, not "a little more").
    Result<std::vector<std::int32_t>> perform(const PaintingAction &action, quint64 drag = 0);

    /// A line of JSON for everything done since the document was opened or begun.
    std::string actionLog() const;
    int logLength() const { return int(mLog.size()); }

    /// What goes into the next snapshot as the project's picture; no edit. Null: the one it has stays.
    void setPicture(const QImage &picture) { mPicture = picture; }

signals:
    /// An action was refused; nothing has changed.
    void refused(const ductus::Error &error);

protected:
    Result<void> readFrom(const Project &project) override;
    void writeTo(Project &project) const override;
    void clear() override;

private:
    friend class EditPainting;

    void show(std::shared_ptr<const Painting> painting, const PaintingChanged &change);
    void beginLog();
    void log(LogEntry entry);

    std::shared_ptr<const Painting> mPainting;
    std::shared_ptr<const PaintingContent> mContent; // as read or last written; what is unknown
    Uuid mDocumentId;
    bool mIsMadeOfSurfaces = false;
    QImage mPicture;

    std::shared_ptr<const Painting> mLogStart;
    QString mLogSource;
    std::vector<LogEntry> mLog;
    bool mIsPerforming = false; // redo() of a new command is no redo of the painter's

    quint64 mDrag = 0; // the last action's
    std::size_t mDragKind = 0;
    std::shared_ptr<const Painting> mDragBase;
};

/// "Add stack": the name of an action as a step of the history.
QString actionText(const PaintingAction &action);

/// What an action may change.
PaintingChanged changeOf(const PaintingAction &action);

} // namespace ductus
