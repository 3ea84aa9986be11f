// HeldLocks: the project locks a document holds, shared with the workers that save it. Usually one; two while
// it is being saved under another name. Thread-safe.
#pragma once

#include "project/saving/project_lock.h"

#include <QString>
#include <map>
#include <mutex>

namespace ductus {

class HeldLocks
{
public:
    bool has(const QString &path) const;
    /// Takes over \a lock of \a path.
    void add(const QString &path, ProjectLock lock);
    /// Takes the lock of \a path unless it is held; it is in use until release(). Errors: those of
    /// ProjectLock::acquire().
    Result<void> use(const QString &path, const std::string &application);
    void release(const QString &path);
    /// Gives all others back but those in use.
    void keepOnly(const QString &path);

private:
    struct Held
    {
        ProjectLock lock;
        int uses = 0;
    };

    mutable std::mutex mMutex;
    std::map<QString, Held> mLocks;
};

} // namespace ductus
