// Document: the content an app edits, with its undo history, its place on the disk and one signal that tells
// views what changed. An app derives its document and implements readFrom() and writeTo(); everything else
// (opening, saving on a worker, knowing what is unsaved) is here and in document_files.h.
#pragma once

#include "document/change_event.h"
#include "document/held_locks.h"
#include "project/project.h"
#include "project/saving/project_lock.h"
#include "project/saving/project_save.h"

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <memory>
#include <optional>

namespace ductus {

class Document : public QObject
{
    Q_OBJECT
public:
    explicit Document(QObject *parent = nullptr);
    ~Document() override;

    /// Every edit is a command on this stack; its text names the user's act ("Move canvas").
    QUndoStack *undoStack() { return &mUndoStack; }
    const QUndoStack *undoStack() const { return &mUndoStack; }

    /// Absolute path of the .ductus file, empty until the document was saved or opened.
    QString filePath() const { return mFilePath; }
    /// The file's name without folder and suffix; "Untitled" (or what setUntitledName() said) without a file.
    QString displayName() const;
    /// For documents made from another file, "hat" of hat.curves: shown until there is a .ductus file.
    void setUntitledName(const QString &name);

    /// True if something would be lost by closing: commands since the last save, or touch().
    bool isModified() const { return mTouched || !mUndoStack.isClean(); }
    /// The file may not be written: made by a newer version, locked by another program, not writable.
    bool isReadOnly() const { return mReadOnly; }
    /// Why, in words; empty unless read-only.
    QString readOnlyReason() const { return mReadOnlyReason; }
    void setReadOnly(const QString &reason);

    /// Counts all changes of the content, undone ones too: equal numbers mean equal content.
    quint64 revision() const { return mRevision; }
    /// Marks a change worth saving that is not a command, such as the result of a job.
    void touch();

    /// A project with the present content in it, for a worker to save; what this app does not know is in it
    /// as it came. Cheap: large parts are shared.
    Project snapshot() const;

    /// Replaces everything by \a project, which stands at \a filePath (empty: not on the disk, such as a
    /// sample or a recovered copy). On failure nothing changes. Emits changed(DocumentReset).
    Result<void> load(Project project, const QString &filePath);
    /// Back to an empty document with a new project id. Emits changed(DocumentReset).
    void reset();

    /// The locks this document holds, for the workers that save it.
    const std::shared_ptr<HeldLocks> &locks() const { return mLocks; }
    bool holdsLock() const { return !mFilePath.isEmpty() && mLocks->has(mFilePath); }
    /// Tells that the content of \a revision is in \a filePath now.
    void markSaved(const QString &filePath, quint64 revision, const SaveReport &report);
    /// Tells that a recovered document is not in any file yet.
    void markUnsaved() { touch(); }

    /// The project last opened or saved: the ids, the other documents, what is kept.
    const Project &project() const { return mProject; }

signals:
    /// The only signal about content. \a event lives during the call.
    void changed(const ductus::ChangeEvent &event);
    void modifiedChanged(bool modified);
    /// Path, name or read-only state are others now.
    void identityChanged();

protected:
    /// Takes the content out of \a project; on failure nothing may have changed. Called by load().
    virtual Result<void> readFrom(const Project &project) = 0;
    /// Puts the present content into \a project (its part of it; nothing else is touched).
    virtual void writeTo(Project &project) const = 0;
    /// Makes the content empty. Called by reset().
    virtual void clear() = 0;

private:
    void becomeClean();
    void noteModified();

    QUndoStack mUndoStack;
    Project mProject;
    std::shared_ptr<HeldLocks> mLocks;
    QString mFilePath;
    QString mUntitledName;
    QString mReadOnlyReason;
    quint64 mRevision = 0;
    bool mReadOnly = false;
    bool mTouched = false;
    bool mWasModified = false;
};

} // namespace ductus
