#include "document/settings/recent_files.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>

namespace ductus {

namespace {

const Setting<QStringList> recentSetting{"recent/files", {}};
constexpr int pictureSide = 160; // pixels, the longer one

} // namespace

RecentFiles::RecentFiles(Settings &settings, const QString &pictureFolder, QObject *parent)
    : QObject(parent), mSettings(settings), mPictureFolder(pictureFolder)
{
}

QString RecentFiles::pictureFile(const QString &path) const
{
    const QByteArray hash =
        QCryptographicHash::hash(path.toUtf8(), QCryptographicHash::Sha256).toHex().left(32);
    return QDir(mPictureFolder).filePath(QString::fromLatin1(hash) + QStringLiteral(".png"));
}

void RecentFiles::store(const QStringList &paths)
{
    for (const QString &old : this->paths()) {
        if (!paths.contains(old))
            QFile::remove(pictureFile(old));
    }
    mSettings.set(recentSetting, paths);
    emit changed();
}

void RecentFiles::add(const QString &path, const QImage &picture)
{
    const QString absolute = QFileInfo(path).absoluteFilePath();
    QStringList list = paths();
    list.removeAll(absolute);
    list.prepend(absolute);
    while (list.size() > mostFiles)
        list.removeLast();
    // A picture that cannot be written is no reason to tell the user anything: the row has a mark instead.
    if (!picture.isNull() && QDir().mkpath(mPictureFolder))
        picture.scaled(pictureSide, pictureSide, Qt::KeepAspectRatio, Qt::SmoothTransformation)
            .save(pictureFile(absolute), "png");
    store(list);
}

void RecentFiles::remove(const QString &path)
{
    QStringList list = paths();
    list.removeAll(QFileInfo(path).absoluteFilePath());
    store(list);
}

void RecentFiles::clear()
{
    store({});
}

QStringList RecentFiles::paths() const
{
    return mSettings.value(recentSetting);
}

QList<RecentFile> RecentFiles::files() const
{
    QList<RecentFile> files;
    for (const QString &path : paths())
        files.append({path, QImage(pictureFile(path)), !QFileInfo::exists(path)});
    return files;
}

} // namespace ductus
