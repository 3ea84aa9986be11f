#include "document/recovery/recovery_list.h"

#include "document/project_picture.h"
#include "document/words/engine_words.h"
#include "project/project_reader.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>
#include <algorithm>

namespace ductus {

namespace {

constexpr qint64 longestNote = 1 << 16; // bytes

QJsonObject readNote(const QString &copy)
{
    QFile file(recoveryNotePath(copy));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    return QJsonDocument::fromJson(file.read(longestNote)).object();
}

bool isHeldByAnother(const QString &copy)
{
    const Result<ProjectLock> lock = ProjectLock::acquire(enginePath(copy), "recovery");
    return !lock && lock.error().code == ErrorCode::Locked;
}

} // namespace

QString recoveryNotePath(const QString &copy)
{
    return copy + QStringLiteral(".json");
}

Result<void> writeRecoveryNote(const QString &copy, const QString &originalPath, const QString &displayName)
{
    QSaveFile file(recoveryNotePath(copy));
    const QJsonObject note{{"originalPath", originalPath}, {"displayName", displayName}};
    if (!file.open(QIODevice::WriteOnly) || file.write(QJsonDocument(note).toJson()) < 0 || !file.commit())
        return Error{ErrorCode::WriteFailed, "Autosaving", file.errorString().toStdString(), "",
                     recoveryNotePath(copy).toStdString()};
    return {};
}

QList<RecoveredFile> recoveredFiles(const QString &folder)
{
    QList<RecoveredFile> files;
    const QFileInfoList copies = QDir(folder).entryInfoList({QStringLiteral("*.ductus")}, QDir::Files);
    for (const QFileInfo &info : copies) {
        RecoveredFile file;
        file.copy = info.absoluteFilePath();
        if (isHeldByAnother(file.copy))
            continue;
        const QJsonObject note = readNote(file.copy);
        file.originalPath = note["originalPath"].toString();
        file.displayName = note["displayName"].toString();
        if (file.displayName.isEmpty())
            file.displayName = info.completeBaseName();
        file.savedAt = info.lastModified();
        if (const Result<Project> project = openProject(enginePath(file.copy)))
            file.thumbnail = projectThumbnail(*project);
        files.append(file);
    }
    std::stable_sort(files.begin(), files.end(),
                     [](const RecoveredFile &a, const RecoveredFile &b) { return a.savedAt > b.savedAt; });
    return files;
}

Result<void> discardRecovered(const RecoveredFile &file)
{
    QFile::remove(recoveryNotePath(file.copy));
    QFile copy(file.copy);
    if (copy.exists() && !copy.remove())
        return Error{ErrorCode::WriteFailed, "Discarding the recovered copy",
                     copy.errorString().toStdString(), "", file.copy.toStdString()};
    return {};
}

Result<OpenNotes> adoptRecovered(Document &document, OpenedProject opened, const RecoveredFile &file)
{
    opened.lock.reset(); // of the copy
    opened.readOnlyReason.clear();
    opened.filePath = file.originalPath;
    if (!file.originalPath.isEmpty()) {
        Result<ProjectLock> lock = ProjectLock::acquire(enginePath(file.originalPath),
                                                        QCoreApplication::applicationName().toStdString());
        if (lock)
            opened.lock.emplace(std::move(lock).value());
        else
            opened.readOnlyReason = engineWords(lock.error().problem);
    }
    Result<OpenNotes> notes = adoptProject(document, std::move(opened));
    if (!notes)
        return notes;
    if (file.originalPath.isEmpty())
        document.setUntitledName(file.displayName);
    document.markUnsaved();
    return notes;
}

} // namespace ductus
