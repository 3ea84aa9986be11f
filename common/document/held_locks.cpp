#include "document/held_locks.h"

#include <QFile>

namespace ductus {

bool HeldLocks::has(const QString &path) const
{
    const std::lock_guard guard(mMutex);
    return mLocks.count(path) > 0;
}

void HeldLocks::add(const QString &path, ProjectLock lock)
{
    const std::lock_guard guard(mMutex);
    mLocks.try_emplace(path, Held{std::move(lock), 0});
}

Result<void> HeldLocks::use(const QString &path, const std::string &application)
{
    const std::lock_guard guard(mMutex);
    auto found = mLocks.find(path);
    if (found == mLocks.end()) {
        Result<ProjectLock> lock =
            ProjectLock::acquire(std::filesystem::path(QFile::encodeName(path).toStdString()), application);
        if (!lock)
            return lock.error();
        found = mLocks.try_emplace(path, Held{std::move(lock).value(), 0}).first;
    }
    ++found->second.uses;
    return {};
}

void HeldLocks::release(const QString &path)
{
    const std::lock_guard guard(mMutex);
    if (const auto found = mLocks.find(path); found != mLocks.end())
        --found->second.uses;
}

void HeldLocks::keepOnly(const QString &path)
{
    const std::lock_guard guard(mMutex);
    for (auto it = mLocks.begin(); it != mLocks.end();)
        it = it->first != path && it->second.uses <= 0 ? mLocks.erase(it) : std::next(it);
}

} // namespace ductus
