#include "document/link_watcher.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QFileSystemWatcher>
#include <QGuiApplication>
#include <QTimer>

namespace ductus {

namespace {

constexpr int settleMilliseconds = 250; // a save writes beside the file and renames: several notices

QString stateOf(const QString &path)
{
    const QFileInfo info(path);
    return info.exists()
               ? QStringLiteral("%1 %2").arg(info.size()).arg(info.lastModified().toMSecsSinceEpoch())
               : QString();
}

} // namespace

LinkWatcher::LinkWatcher(QObject *parent)
    : QObject(parent), mWatcher(new QFileSystemWatcher(this)), mSettle(new QTimer(this))
{
    mSettle->setSingleShot(true);
    mSettle->setInterval(settleMilliseconds);
    connect(mSettle, &QTimer::timeout, this, &LinkWatcher::lookIfChanged);
    const auto settle = [this] { mSettle->start(); };
    connect(mWatcher, &QFileSystemWatcher::fileChanged, this, settle);
    connect(mWatcher, &QFileSystemWatcher::directoryChanged, this, settle);
    // Network folders tell nothing: coming back to the window is the moment to look there.
    if (auto *application = qobject_cast<QGuiApplication *>(QCoreApplication::instance()))
        connect(application, &QGuiApplication::applicationStateChanged, this,
                [this](Qt::ApplicationState state) {
                    if (state == Qt::ApplicationActive)
                        mSettle->start();
                });
}

LinkWatcher::~LinkWatcher() = default;

void LinkWatcher::setFiles(const QStringList &paths)
{
    if (paths == mFiles)
        return;
    mFiles = paths;
    mStates.clear();
    for (const QString &path : mFiles)
        mStates << stateOf(path);
    watchAgain();
}

// A renamed file is watched no more: the folder tells of the one in its place.
void LinkWatcher::watchAgain()
{
    if (const QStringList watched = mWatcher->files() + mWatcher->directories(); !watched.isEmpty())
        mWatcher->removePaths(watched);
    QStringList wanted;
    for (const QString &path : mFiles) {
        const QFileInfo info(path);
        if (info.exists())
            wanted << path;
        if (info.dir().exists() && !wanted.contains(info.absolutePath()))
            wanted << info.absolutePath();
    }
    if (!wanted.isEmpty())
        mWatcher->addPaths(wanted);
}

void LinkWatcher::lookIfChanged()
{
    QStringList states;
    for (const QString &path : mFiles)
        states << stateOf(path);
    if (states == mStates)
        return;
    mStates = states;
    watchAgain();
    emit worthALook();
}

} // namespace ductus
