#include "document/recovery/autosave.h"

#include "document/document_files.h"
#include "document/recovery/recovery_list.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QPointer>
#include <atomic>

namespace ductus {

struct CopyOwner
{
    std::optional<ProjectLock> lock; // says that we are alive; used by one worker at a time
    std::atomic<bool> isUnwanted = false;
};

namespace {

struct CopyRequest
{
    Project project;
    QString folder;
    QString copy;
    QString originalPath;
    QString displayName;
    QString application;
};

// On a worker.
Result<SaveReport> writeCopy(const CopyRequest &request, std::optional<ProjectLock> &lock)
{
    if (!QDir().mkpath(request.folder))
        return Error{ErrorCode::WriteFailed, "Autosaving", "the folder cannot be made",
                     "Make room on the disk or check the folder's permissions", request.folder.toStdString()};
    // Other people's eyes have no business in unfinished work.
    QFile::setPermissions(request.folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    if (!lock) {
        Result<ProjectLock> taken =
            ProjectLock::acquire(enginePath(request.copy), request.application.toStdString());
        if (!taken)
            return taken.error();
        lock.emplace(std::move(taken).value());
    }
    if (Result<void> note = writeRecoveryNote(request.copy, request.originalPath, request.displayName); !note)
        return note.error();
    return saveProject(request.project, enginePath(request.copy));
}

void removeCopy(const QString &copy)
{
    QFile::remove(recoveryNotePath(copy));
    QFile::remove(copy);
    QFile::remove(copy + QLatin1Char('~'));
}

} // namespace

Autosave::Autosave(Document &document, JobRunner &runner, const QString &folder, QObject *parent)
    : QObject(parent), mDocument(document), mRunner(runner), mFolder(folder)
{
    mTimer.setSingleShot(true);
    connect(&mTimer, &QTimer::timeout, this, &Autosave::onTimer);
    connect(&document, &Document::modifiedChanged, this, &Autosave::onModified);
    connect(&document, &Document::changed, this, [this](const ChangeEvent &event) {
        if (event.as<DocumentReset>())
            discard();
        else if (mDocument.isModified()) // again: the result of a job is no command
            onModified(true);
    });
    connect(document.undoStack(), &QUndoStack::indexChanged, this,
            [this] { onModified(mDocument.isModified()); });
    newCopy();
}

Autosave::~Autosave() = default;

void Autosave::newCopy()
{
    mCopy = QDir(mFolder).absoluteFilePath(QString::fromStdString(Uuid::create().text()) +
                                           QStringLiteral(".ductus"));
    mOwner = std::make_shared<CopyOwner>();
    mSavedRevision.reset();
}

void Autosave::setTimes(const AutosaveTimes &times)
{
    mTimes = times;
    if (mTimer.isActive())
        schedule(mTimes.intervalMs);
}

void Autosave::schedule(int milliseconds)
{
    mTimer.start(milliseconds);
}

void Autosave::onModified(bool modified)
{
    if (!modified) {
        // Saved: the copy would only be in the way.
        if (mSavedRevision || mIsWriting)
            discard();
        mTimer.stop();
        return;
    }
    if (!mTimer.isActive() && mSavedRevision != mDocument.revision())
        schedule(mTimes.intervalMs);
}

void Autosave::onTimer()
{
    if (!mDocument.isModified() || mSavedRevision == mDocument.revision())
        return;
    const bool isBusy = mIsBusy && mIsBusy();
    if (mIsWriting || (isBusy && mPostponedMs < mTimes.longestPostponedMs)) {
        mPostponedMs += mTimes.postponedMs;
        schedule(mTimes.postponedMs);
        return;
    }
    write();
}

void Autosave::saveNow()
{
    if (mDocument.isModified() && mSavedRevision != mDocument.revision() && !mIsWriting)
        write();
}

void Autosave::write()
{
    mTimer.stop();
    mPostponedMs = 0;
    mIsWriting = true;
    emit aboutToWrite();
    auto request = std::make_shared<CopyRequest>();
    request->project = mDocument.snapshot();
    // A newer version's file may be read only; the copy is no more than our own notes on it.
    request->folder = mFolder;
    request->copy = mCopy;
    request->originalPath = mDocument.filePath();
    request->displayName = mDocument.displayName();
    request->application = QCoreApplication::applicationName();
    const quint64 revision = mDocument.revision();
    JobSpec spec{QStringLiteral("autosave"), tr("Autosaving")};
    spec.isQuiet = true;
    spec.canCancel = false;
    spec.isQueued = true;
    mRunner.start<SaveReport>(
        spec,
        [request, owner = mOwner](const JobControl &) {
            Result<SaveReport> report = writeCopy(*request, owner->lock);
            // Discarded meanwhile, perhaps with the window: nobody else will look after it.
            if (owner->isUnwanted)
                removeCopy(request->copy);
            return report;
        },
        [self = QPointer(this), request, revision](Result<SaveReport> report) {
            if (!self)
                return;
            self->mIsWriting = false;
            if (request->copy != self->mCopy) { // discarded meanwhile
                self->onModified(self->mDocument.isModified());
                return;
            }
            if (!report) {
                self->schedule(self->mTimes.afterFailureMs);
                emit self->failed(report.error());
                return;
            }
            self->mSavedRevision = revision;
            emit self->saved();
            self->onModified(self->mDocument.isModified());
        });
}

void Autosave::discard()
{
    mTimer.stop();
    mPostponedMs = 0;
    mOwner->isUnwanted = true; // first: a write that ends now sees it, or its file is there below
    if (mSavedRevision || QFile::exists(mCopy))
        removeCopy(mCopy);
    newCopy();
}

} // namespace ductus
