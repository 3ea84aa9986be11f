// RecentFiles: the files opened last, newest first, each with a small picture, remembered in the settings.
// Pictures are PNGs in a cache folder; those of files that fell off the list are removed.
#pragma once

#include "document/settings/settings.h"

#include <QImage>
#include <QList>
#include <QObject>

namespace ductus {

struct RecentFile
{
    QString path;   // absolute
    QImage picture; // may be null
    bool isMissing = false;
};

class RecentFiles : public QObject
{
    Q_OBJECT
public:
    static constexpr int mostFiles = 12;

    /// \a settings must outlive this; \a pictureFolder is made when first needed.
    RecentFiles(Settings &settings, const QString &pictureFolder, QObject *parent = nullptr);

    /// Puts \a path first. A null picture keeps the one it had.
    void add(const QString &path, const QImage &picture = {});
    void remove(const QString &path);
    void clear();

    QStringList paths() const;
    /// Looks whether each is still there and reads the pictures.
    QList<RecentFile> files() const;

signals:
    void changed();

private:
    QString pictureFile(const QString &path) const;
    void store(const QStringList &paths);

    Settings &mSettings;
    QString mPictureFolder;
};

} // namespace ductus
