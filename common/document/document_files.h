// Opening and saving documents without holding up the window: the parts that touch the disk run on a worker
// and know nothing of the Document, the parts that touch the Document run on the UI thread.
//
//     openDocument(document, runner, path, [this](Result<OpenNotes> result) { ... });
//     saveDocument(document, runner, path, [this](Result<SaveReport> result) { ... });
#pragma once

#include "document/document.h"
#include "document/jobs/job_runner.h"
#include "project/project_reader.h"

#include <QStringList>
#include <functional>

namespace ductus {

/// A project as it came from the disk, with the lock on it if there is one to have.
struct OpenedProject
{
    Project project;
    QString filePath;
    std::optional<ProjectLock> lock;
    QString readOnlyReason; // empty: may be written
};

/// What the user should be told about a file that was opened; one line each.
struct OpenNotes
{
    QStringList warnings;
};

/// What a worker needs to save a document.
struct SaveRequest
{
    Project project;
    QString filePath;
    QString application; // for the lock
    quint64 revision = 0;
    std::shared_ptr<HeldLocks> locks; // of the document
};

/// For openProject(): all kinds of documents the apps know.
ProjectReadOptions knownDocuments();

/// Reads the project at \a path and takes its lock, unless \a isLocked says that it is ours already; a
/// project that is locked or lies in a folder that cannot be written is opened read-only. Errors: those of
/// openProject(). For workers.
Result<OpenedProject> openProjectFile(const QString &path, const QString &application, bool isLocked = false);

/// Puts \a opened into \a document. Errors: those of its readFrom(); nothing changed then. UI thread.
Result<OpenNotes> adoptProject(Document &document, OpenedProject opened);

/// A snapshot of \a document to be saved at \a path. UI thread.
SaveRequest saveRequest(const Document &document, const QString &path);

/// Takes the lock unless the document has it, and writes the file. Errors: Locked, those of saveProject().
/// For workers.
Result<SaveReport> writeSave(const SaveRequest &request);

/// Opens \a path into \a document as one job of \a runner; the document must outlive the runner's jobs or be
/// destroyed before: then nothing is done. The document stays as it was on failure.
JobId openDocument(Document &document, JobRunner &runner, const QString &path,
                   std::function<void(Result<OpenNotes>)> finish);

/// Saves \a document at \a path (empty: where it is) as one job. The document can be edited meanwhile.
JobId saveDocument(Document &document, JobRunner &runner, const QString &path,
                   std::function<void(Result<SaveReport>)> finish);

/// \a path for the engine: bytes of the system's file names.
std::filesystem::path enginePath(const QString &path);

} // namespace ductus
