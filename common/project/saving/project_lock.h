// ProjectLock: one writer a project. name.ductus.lock says who; flock() on it says whether they are still
// alive, so a lock whose owner was killed is taken over without asking.
#pragma once

#include "base/result.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace ductus {

struct LockOwner
{
    std::int64_t pid = 0;
    std::string host;
    std::string user;
    std::string application;      // "SketchSurfacer"
    std::string bootId;           // of the running system; pids of another boot mean nothing
    std::uint64_t startTicks = 0; // of the process since boot: tells it from a later one with the same pid

    /// This process.
    static LockOwner self(std::string application);
    std::string toText() const;
    /// Malformed for anything toText() did not write.
    static Result<LockOwner> parse(std::string_view text);

    /// "SketchSurfacer (user ann, process 4711 on host desk)"
    std::string description() const;

    /// False if the process certainly ended: this host, and no such process or another one with its pid.
    bool mayBeAlive() const;
};

class ProjectLock
{
public:
    /// Takes the lock of the project \a path. Locked (naming the owner) if another program has it, or one on
    /// another host had it and did not give it back; PermissionDenied where no lock can be written: open
    /// read-only then.
    static Result<ProjectLock> acquire(const std::filesystem::path &path, const std::string &application);

    /// Removes a lock left by another host, after the user said so. Fails with Locked if its owner is alive
    /// here.
    static Result<void> breakLock(const std::filesystem::path &path);

    /// Gives the lock back.
    ~ProjectLock();
    ProjectLock(ProjectLock &&other) noexcept;
    ProjectLock &operator=(ProjectLock &&) = delete;

private:
    ProjectLock(std::filesystem::path file, int descriptor) : mFile(std::move(file)), mDescriptor(descriptor)
    {
    }

    std::filesystem::path mFile;
    int mDescriptor = -1;
};

/// name.ductus.lock
std::filesystem::path lockPath(const std::filesystem::path &path);

} // namespace ductus
