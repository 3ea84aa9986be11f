#include "document/document.h"

#include <QFileInfo>

namespace ductus {

Document::Document(QObject *parent) : QObject(parent), mLocks(std::make_shared<HeldLocks>())
{
    mProject.id = Uuid::create();
    // Merged commands keep the index but emit the signal, so this counts them, too.
    connect(&mUndoStack, &QUndoStack::indexChanged, this, [this] { ++mRevision; });
    connect(&mUndoStack, &QUndoStack::cleanChanged, this, &Document::noteModified);
}

Document::~Document()
{
    mUndoStack.disconnect(this);
}

QString Document::displayName() const
{
    if (!mFilePath.isEmpty())
        return QFileInfo(mFilePath).completeBaseName();
    return mUntitledName.isEmpty() ? tr("Untitled") : mUntitledName;
}

void Document::setUntitledName(const QString &name)
{
    mUntitledName = name;
    emit identityChanged();
}

void Document::setReadOnly(const QString &reason)
{
    mReadOnly = !reason.isEmpty();
    mReadOnlyReason = reason;
    emit identityChanged();
}

void Document::touch()
{
    ++mRevision;
    mTouched = true;
    noteModified();
}

Project Document::snapshot() const
{
    Project project = mProject;
    writeTo(project);
    return project;
}

Result<void> Document::load(Project project, const QString &filePath)
{
    if (Result<void> read = readFrom(project); !read)
        return read;
    mProject = std::move(project);
    mLocks->keepOnly(filePath); // a file that is opened again stays ours
    mFilePath = filePath;
    mUntitledName.clear();
    mReadOnlyReason = mProject.readOnly ? tr("it was made by a newer version of Ductus") : QString();
    mReadOnly = mProject.readOnly;
    becomeClean();
    return {};
}

void Document::reset()
{
    clear();
    mProject = Project();
    mProject.id = Uuid::create();
    mFilePath.clear();
    mUntitledName.clear();
    mLocks->keepOnly({});
    mReadOnly = false;
    mReadOnlyReason.clear();
    becomeClean();
}

void Document::markSaved(const QString &filePath, quint64 revision, const SaveReport &report)
{
    mProject.buffers = report.buffers;
    const bool isOtherFile = filePath != mFilePath;
    mFilePath = filePath;
    mLocks->keepOnly(filePath);
    if (isOtherFile)
        mReadOnlyReason.clear();
    mReadOnly = !mReadOnlyReason.isEmpty();
    if (revision == mRevision) {
        mTouched = false;
        mUndoStack.setClean();
    }
    noteModified();
    if (isOtherFile)
        emit identityChanged();
}

void Document::becomeClean()
{
    mTouched = false;
    mUndoStack.clear();
    ++mRevision;
    emit changed(DocumentReset());
    emit identityChanged();
    noteModified();
}

void Document::noteModified()
{
    if (isModified() == mWasModified)
        return;
    mWasModified = isModified();
    emit modifiedChanged(mWasModified);
}

} // namespace ductus
