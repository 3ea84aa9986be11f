// Autosave: a copy of unsaved work in the state folder, written by a quiet job, so that a crash costs a few
// minutes. Postponed while the user is in the middle of something (a stroke must not stutter), sooner after a
// failure, removed once the document is saved or closed.
#pragma once

#include "document/document.h"
#include "document/jobs/job_runner.h"

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

namespace ductus {

struct AutosaveTimes
{
    int intervalMs = 120'000;        // from the first unsaved change
    int postponedMs = 3'000;         // asked again while busy
    int longestPostponedMs = 60'000; // then it is written all the same
    int afterFailureMs = 15'000;
};

struct CopyOwner; // what the worker that writes a copy shares with the Autosave it is of

class Autosave : public QObject
{
    Q_OBJECT
public:
    /// Copies of \a document go into \a folder, made when first needed (see state_folder.h). Both references
    /// must outlive this.
    Autosave(Document &document, JobRunner &runner, const QString &folder, QObject *parent = nullptr);
    /// Leaves the copy: only discard() and saving remove it.
    ~Autosave() override;

    void setTimes(const AutosaveTimes &times);
    /// Asked before writing: true while a stroke is drawn or something is dragged.
    void setBusyCheck(std::function<bool()> isBusy) { mIsBusy = std::move(isBusy); }

    /// Writes now if there is something to write.
    void saveNow();
    /// Removes the copy: the user closed the document and wanted nothing of it.
    void discard();

    /// Where the copy is or would be.
    QString copyPath() const { return mCopy; }
    /// Revision of the document that is in the copy, if there is one.
    std::optional<quint64> savedRevision() const { return mSavedRevision; }

signals:
    /// Right before the document's snapshot is taken: the moment to renew what goes along, such as a picture.
    void aboutToWrite();
    void saved();
    void failed(const ductus::Error &error);

private:
    void schedule(int milliseconds);
    void onTimer();
    void onModified(bool modified);
    void newCopy();
    void write();

    Document &mDocument;
    JobRunner &mRunner;
    QString mFolder;
    QString mCopy;
    AutosaveTimes mTimes;
    std::function<bool()> mIsBusy;
    QTimer mTimer;
    int mPostponedMs = 0;
    bool mIsWriting = false;
    std::optional<quint64> mSavedRevision;
    std::shared_ptr<CopyOwner> mOwner; // of mCopy
};

} // namespace ductus
