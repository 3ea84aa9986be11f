#include "document/document_files.h"

#include "document/words/engine_words.h"
#include "doodling/storage/doodle_content.h"
#include "painting/storage/painting_content.h"
#include "project/project_reader.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QPointer>

namespace ductus {

namespace {

QString inWords(const Error &error)
{
    return engineWords(error.problem);
}

struct Words
{
    Q_DECLARE_TR_FUNCTIONS(ductus::DocumentFiles)
};

Error goneError(const char *attempted)
{
    return cancelledError(attempted);
}

} // namespace

std::filesystem::path enginePath(const QString &path)
{
    return std::filesystem::path(QFile::encodeName(path).toStdString());
}

ProjectReadOptions knownDocuments()
{
    ProjectReadOptions options;
    options.kinds = {paintingKind(), doodleKind()};
    return options;
}

Result<OpenedProject> openProjectFile(const QString &path, const QString &application, bool isLocked)
{
    OpenedProject opened;
    opened.filePath = QFileInfo(path).absoluteFilePath();
    // The lock first: between reading and locking another program could save. None for a file that is not
    // there: that would leave a lock file behind.
    if (!isLocked && QFileInfo(opened.filePath).isFile()) {
        Result<ProjectLock> lock =
            ProjectLock::acquire(enginePath(opened.filePath), application.toStdString());
        if (lock)
            opened.lock.emplace(std::move(lock).value());
        else
            opened.readOnlyReason = inWords(lock.error());
    }
    Result<Project> project = openProject(enginePath(opened.filePath), knownDocuments());
    if (!project)
        return project.error();
    opened.project = std::move(project).value();
    if (opened.readOnlyReason.isEmpty() && !QFileInfo(opened.filePath).isWritable()) {
        opened.readOnlyReason = Words::tr("the file may not be written");
        opened.lock.reset();
    }
    return opened;
}

Result<OpenNotes> adoptProject(Document &document, OpenedProject opened)
{
    OpenNotes notes;
    for (const std::string &warning : opened.project.warnings)
        notes.warnings << QString::fromStdString(warning);
    if (Result<void> loaded = document.load(std::move(opened.project), opened.filePath); !loaded)
        return loaded.error();
    if (opened.lock)
        document.locks()->add(opened.filePath, std::move(*opened.lock));
    if (!document.isReadOnly() && !opened.readOnlyReason.isEmpty())
        document.setReadOnly(opened.readOnlyReason);
    if (document.isReadOnly())
        notes.warnings << Words::tr(
                              "%1 is open for reading only: %2. Save under another name to keep changes.")
                              .arg(document.displayName(), document.readOnlyReason());
    return notes;
}

SaveRequest saveRequest(const Document &document, const QString &path)
{
    SaveRequest request;
    request.filePath = QFileInfo(path.isEmpty() ? document.filePath() : path).absoluteFilePath();
    request.project = document.snapshot();
    request.application = QCoreApplication::applicationName();
    request.revision = document.revision();
    request.locks = document.locks();
    return request;
}

Result<SaveReport> writeSave(const SaveRequest &request)
{
    if (Result<void> lock = request.locks->use(request.filePath, request.application.toStdString()); !lock)
        return lock.error();
    Result<SaveReport> report = saveProject(request.project, enginePath(request.filePath));
    request.locks->release(request.filePath);
    return report;
}

JobId openDocument(Document &document, JobRunner &runner, const QString &path,
                   std::function<void(Result<OpenNotes>)> finish)
{
    const QString application = QCoreApplication::applicationName();
    const bool isLocked = document.holdsLock() && document.filePath() == QFileInfo(path).absoluteFilePath();
    const JobSpec spec{QStringLiteral("open"), Words::tr("Opening %1").arg(QFileInfo(path).fileName())};
    return runner.start<OpenedProject>(
        spec,
        [path, application, isLocked](const JobControl &control) {
            control.progress(0.0, Words::tr("Reading the file").toStdString());
            return openProjectFile(path, application, isLocked);
        },
        [target = QPointer(&document), finish](Result<OpenedProject> opened) {
            if (!target)
                finish(goneError("Opening the project"));
            else if (!opened)
                finish(opened.error());
            else
                finish(adoptProject(*target, std::move(opened).value()));
        });
}

JobId saveDocument(Document &document, JobRunner &runner, const QString &path,
                   std::function<void(Result<SaveReport>)> finish)
{
    auto request = std::make_shared<SaveRequest>(saveRequest(document, path));
    // One after the other, and not to be cancelled half way: it takes a second.
    const JobSpec spec{QStringLiteral("save"),
                       Words::tr("Saving %1").arg(QFileInfo(request->filePath).fileName()), false, false,
                       true};
    return runner.start<SaveReport>(
        spec,
        [request](const JobControl &control) {
            control.progress(0.0, Words::tr("Writing the file").toStdString());
            return writeSave(*request);
        },
        [target = QPointer(&document), request, finish](Result<SaveReport> report) {
            if (report && target)
                target->markSaved(request->filePath, request->revision, *report);
            finish(std::move(report));
        });
}

} // namespace ductus
