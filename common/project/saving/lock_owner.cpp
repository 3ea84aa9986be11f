// LockOwner: what a lock file says, and whether that process is still there.
#include "project/saving/project_lock.h"

#include "project/json/json_reader.h"
#include "project/json/json_writer.h"

#include <pwd.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <limits>
#include <sstream>

namespace ductus {

namespace {

std::string firstLine(const std::string &path)
{
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    return line;
}

// Field 22 of /proc/<pid>/stat; the name before it may contain anything, but it ends at the last parenthesis.
std::uint64_t startTicksOf(std::int64_t pid)
{
    const std::string line = firstLine("/proc/" + std::to_string(pid) + "/stat");
    const std::size_t end = line.rfind(')');
    if (end == std::string::npos)
        return 0;
    std::istringstream fields(line.substr(end + 1));
    std::string skipped;
    for (int field = 3; field < 22; ++field)
        fields >> skipped;
    std::uint64_t ticks = 0;
    fields >> ticks;
    return ticks;
}

std::string hostName()
{
    std::array<char, 256> name = {};
    ::gethostname(name.data(), name.size() - 1);
    return name.data();
}

std::string userName()
{
    std::array<char, 4096> buffer = {};
    passwd entry = {};
    passwd *found = nullptr;
    if (::getpwuid_r(::geteuid(), &entry, buffer.data(), buffer.size(), &found) == 0 && found)
        return found->pw_name;
    return std::to_string(::geteuid());
}

} // namespace

LockOwner LockOwner::self(std::string application)
{
    LockOwner owner;
    owner.pid = ::getpid();
    owner.host = hostName();
    owner.user = userName();
    owner.application = std::move(application);
    owner.bootId = firstLine("/proc/sys/kernel/random/boot_id");
    owner.startTicks = startTicksOf(owner.pid);
    return owner;
}

std::string LockOwner::toText() const
{
    const OrderedJson json = {{"pid", pid},     {"host", host},
                              {"user", user},   {"application", application},
                              {"boot", bootId}, {"start", startTicks}};
    return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

Result<LockOwner> LockOwner::parse(std::string_view text)
{
    const Result<JsonDocument> json = parsedJson(std::string(text), "lock");
    if (!json)
        return json.error();
    const JsonReader reader(*json, "lock");
    LockOwner owner;
    owner.pid = reader.integer("pid", 1, std::numeric_limits<pid_t>::max());
    owner.host = reader.string("host", 256);
    owner.user = reader.string("user", 256);
    owner.application = reader.string("application", 256);
    owner.bootId = reader.string("boot", 256);
    owner.startTicks = reader.unsignedInteger("start");
    if (reader.failed())
        return reader.error();
    return owner;
}

std::string LockOwner::description() const
{
    return application + " (user " + user + ", process " + std::to_string(pid) + " on host " + host + ")";
}

bool LockOwner::mayBeAlive() const
{
    const LockOwner here = self({});
    if (host != here.host)
        return true;
    if (bootId != here.bootId)
        return false;
    if (::kill(pid_t(pid), 0) != 0 && errno == ESRCH)
        return false;
    return startTicksOf(pid) == startTicks;
}

} // namespace ductus
