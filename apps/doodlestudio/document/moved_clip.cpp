#include "doodlestudio/document/moved_clip.h"

#include "document/document_files.h"
#include "doodling/clip/clip_digest.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include <algorithm>

namespace ductus {

namespace {

constexpr char attempted[] = "Looking which clip it is";
constexpr qint64 mostBytes = qint64(4) << 30; // read before giving up: some ten seconds
constexpr int mostEntries = 2000;             // of a folder

// Clips of a folder: of the name first, then of the same kind.
void addClips(const QString &folder, const QFileInfo &wanted, QStringList &named, QStringList &others)
{
    const QFileInfoList entries = QDir(folder).entryInfoList(
        QDir::Files | QDir::Dirs | QDir::NoDotAndDotDot | QDir::Readable, QDir::Name);
    for (const QFileInfo &entry : entries.mid(0, mostEntries)) {
        if (entry.fileName() == wanted.fileName())
            named << entry.absoluteFilePath();
        else if (entry.suffix().compare(wanted.suffix(), Qt::CaseInsensitive) == 0 &&
                 looksLikeClip(entry.absoluteFilePath()))
            others << entry.absoluteFilePath();
    }
}

QStringList foldersBelow(const QString &folder)
{
    QStringList folders;
    const QFileInfoList entries =
        QDir(folder).entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot | QDir::Readable, QDir::Name);
    for (const QFileInfo &entry : entries.mid(0, mostEntries))
        folders << entry.absoluteFilePath();
    return folders;
}

qint64 bytesOf(const QString &clip)
{
    const QFileInfo info(clip);
    if (!info.isDir())
        return info.size();
    qint64 bytes = 0;
    for (const QFileInfo &file : QDir(clip).entryInfoList(QDir::Files))
        bytes += file.size();
    return bytes;
}

} // namespace

QStringList placesOfClips(const QString &clip, const QString &project)
{
    QStringList places;
    if (!project.isEmpty())
        places << QFileInfo(project).absolutePath();
    places << QFileInfo(clip).absolutePath();
    for (QStandardPaths::StandardLocation location :
         {QStandardPaths::MoviesLocation, QStandardPaths::DownloadLocation, QStandardPaths::DesktopLocation,
          QStandardPaths::DocumentsLocation})
        places += QStandardPaths::standardLocations(location);
    places.removeDuplicates();
    return places;
}

Result<QString> movedClip(const ClipReference &known, const QString &path, const QStringList &folders,
                          const JobControl &control)
{
    if (known.digest.empty())
        return QString();
    control.progress(0.0, attempted);
    QStringList named, others;
    for (const QString &folder : folders) {
        if (control.isCancelled())
            return cancelledError(attempted);
        addClips(folder, QFileInfo(path), named, others);
        for (const QString &below : foldersBelow(folder))
            addClips(below, QFileInfo(path), named, others);
    }
    QStringList candidates = named + others;
    candidates.removeDuplicates();
    qint64 bytes = 0;
    for (qsizetype i = 0; i < candidates.size(); ++i) {
        const qint64 size = bytesOf(candidates[i]);
        if (bytes + size > mostBytes)
            continue;
        bytes += size;
        const double share = 1.0 / double(candidates.size());
        const Result<std::string> digest =
            clipDigest(enginePath(candidates[i]), control.part(double(i) * share, double(i + 1) * share));
        if (control.isCancelled())
            return cancelledError(attempted);
        if (digest && *digest == known.digest)
            return candidates[i];
    }
    return QString();
}

} // namespace ductus
