#include "document/document_files.h"

#include "project/project_reader.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QPointer>

namespace ductus {

namespace {

QString inWords(const Error &error)
{
    return QString::fromStdString(error.problem);
}

QString text(const char *source)
{
    return QCoreApplication::translate("ductus::DocumentFiles", source);
}

Error goneError(const char *attempted)
{
    return cancelledError(attempted);
}

} // namespace

std::filesystem::path enginePath(const QString &path)
{
    return std::filesystem::path(QFile::encodeName(path).toStdString());
}

Result<OpenedProject> openProjectFile(const QString &path, const QString &application)
{
    OpenedProject opened;
    opened.filePath = QFileInfo(path).absoluteFilePath();
    // The lock first: between reading and locking another program could save.
    Result<ProjectLock> lock = ProjectLock::acquire(enginePath(opened.filePath), application.toStdString());
    Result<Project> project = openProject(enginePath(opened.filePath));
    if (!project)
        return project.error();
    opened.project = std::move(project).value();
    if (!lock)
        opened.readOnlyReason = inWords(lock.error());
    else if (!QFileInfo(opened.filePath).isWritable())
        opened.readOnlyReason = text("the file may not be written");
    else
        opened.lock.emplace(std::move(lock).value());
    return opened;
}

Result<OpenNotes> adoptProject(Document &document, OpenedProject opened)
{
    OpenNotes notes;
    for (const std::string &warning : opened.project.warnings)
        notes.warnings << QString::fromStdString(warning);
    if (Result<void> loaded = document.load(std::move(opened.project), opened.filePath); !loaded)
        return loaded.error();
    document.setLock(std::move(opened.lock));
    if (!document.isReadOnly() && !opened.readOnlyReason.isEmpty())
        document.setReadOnly(opened.readOnlyReason);
    if (document.isReadOnly())
        notes.warnings << text("%1 is open for reading only: %2. Save under another name to keep changes.")
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
    request.needsLock = request.filePath != document.filePath() || !document.holdsLock();
    return request;
}

Result<SaveOutcome> writeSave(const SaveRequest &request)
{
    SaveOutcome outcome;
    const std::filesystem::path path = enginePath(request.filePath);
    if (request.needsLock) {
        Result<ProjectLock> lock = ProjectLock::acquire(path, request.application.toStdString());
        if (!lock)
            return lock.error();
        outcome.lock.emplace(std::move(lock).value());
    }
    Result<SaveReport> report = saveProject(request.project, path);
    if (!report)
        return report.error();
    outcome.report = std::move(report).value();
    return outcome;
}

JobId openDocument(Document &document, JobRunner &runner, const QString &path,
                   std::function<void(Result<OpenNotes>)> finish)
{
    const QString application = QCoreApplication::applicationName();
    const JobSpec spec{QStringLiteral("open"), text("Opening %1").arg(QFileInfo(path).fileName())};
    return runner.start<OpenedProject>(
        spec,
        [path, application](const JobControl &control) {
            control.progress(0.0, text("Reading the file").toStdString());
            return openProjectFile(path, application);
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
    // Not to be replaced by the next save half way, and not to be cancelled: it takes a second.
    const JobSpec spec{{}, text("Saving %1").arg(QFileInfo(request->filePath).fileName()), false, false};
    return runner.start<SaveOutcome>(
        spec,
        [request](const JobControl &control) {
            control.progress(0.0, text("Writing the file").toStdString());
            return writeSave(*request);
        },
        [target = QPointer(&document), request, finish](Result<SaveOutcome> outcome) {
            if (!outcome) {
                finish(outcome.error());
                return;
            }
            if (target) {
                if (outcome->lock)
                    target->setLock(std::move(outcome->lock));
                target->markSaved(request->filePath, request->revision, outcome->report);
            }
            finish(std::move(outcome->report));
        });
}

} // namespace ductus
