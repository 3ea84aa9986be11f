// LinkWatcher: tells when it is worth looking whether what a document was made from has changed: another
// program wrote one of the files, or the user comes back from another window.
#pragma once

#include <QObject>
#include <QStringList>

class QFileSystemWatcher;
class QTimer;

namespace ductus {

class LinkWatcher : public QObject
{
    Q_OBJECT
public:
    explicit LinkWatcher(QObject *parent = nullptr);
    ~LinkWatcher() override;

    /// The files to watch instead of those before; they need not be there yet.
    void setFiles(const QStringList &paths);
    const QStringList &files() const { return mFiles; }

signals:
    /// Once for writes that follow each other closely; not when no file is watched.
    void worthALook();

private:
    void watchAgain();
    void lookIfChanged();

    QFileSystemWatcher *mWatcher;
    QTimer *mSettle;
    QStringList mFiles;
    QStringList mStates; // size and time of each file when it was last told of
};

} // namespace ductus
