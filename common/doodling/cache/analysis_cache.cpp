#include "doodling/cache/analysis_cache.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <vector>

namespace ductus {

namespace {

namespace fs = std::filesystem;

constexpr char usedFile[] = "used"; // its time says when

struct KeptFolder
{
    fs::path path;
    fs::file_time_type used;
    std::uint64_t bytes = 0;
};

KeptFolder factsOf(const fs::path &path)
{
    std::error_code failure;
    KeptFolder kept{path, fs::last_write_time(path / usedFile, failure), 0};
    if (failure)
        kept.used = fs::file_time_type::min();
    for (fs::recursive_directory_iterator file(path, failure), end; !failure && file != end;
         file.increment(failure)) {
        const std::uint64_t bytes = file->is_regular_file(failure) ? file->file_size(failure) : 0;
        if (!failure)
            kept.bytes += bytes;
        failure.clear(); // removed meanwhile
    }
    return kept;
}

} // namespace

Result<fs::path> AnalysisCache::folder(const std::string &key) const
{
    const fs::path path = root / key;
    std::error_code failure;
    fs::create_directories(path, failure);
    std::ofstream used(path / usedFile, std::ios::trunc);
    used << '\n';
    used.close();
    if (failure || !used)
        return Error{ErrorCode::WriteFailed, "Keeping what was found out about the clip",
                     failure ? failure.message() : "the folder cannot be written to",
                     "Name a folder that can be written to in XDG_CACHE_HOME", path.string()};
    makeRoom(key);
    return path;
}

void AnalysisCache::makeRoom(const std::string &keptKey) const
{
    std::vector<KeptFolder> others;
    std::uint64_t bytes = 0;
    std::error_code failure;
    for (fs::directory_iterator folder(root, failure), end; !failure && folder != end;
         folder.increment(failure)) {
        std::error_code unreadable;
        if (!folder->is_directory(unreadable))
            continue;
        KeptFolder kept = factsOf(folder->path());
        bytes += kept.bytes;
        if (folder->path().filename() != keptKey)
            others.push_back(std::move(kept));
    }
    std::sort(others.begin(), others.end(), [](const KeptFolder &a, const KeptFolder &b) {
        return a.used != b.used ? a.used < b.used : a.path < b.path;
    });
    for (const KeptFolder &old : others) {
        if (bytes <= mostBytes)
            return;
        fs::remove_all(old.path, failure); // what cannot be removed now is tried again next time
        bytes -= old.bytes;
    }
}

AnalysisCache userAnalysisCache()
{
    AnalysisCache cache;
    const char *cacheHome = std::getenv("XDG_CACHE_HOME");
    const char *home = std::getenv("HOME");
    if (cacheHome && fs::path(cacheHome).is_absolute()) // others are to be ignored [XDG base directories]
        cache.root = fs::path(cacheHome) / "ductus/clips";
    else if (home && fs::path(home).is_absolute())
        cache.root = fs::path(home) / ".cache/ductus/clips";
    if (const char *bound = std::getenv("DUCTUS_CACHE_MEGABYTES")) {
        std::uint64_t megabytes = 0;
        const char *end = bound + std::strlen(bound);
        if (const auto read = std::from_chars(bound, end, megabytes);
            read.ec == std::errc() && read.ptr == end) {
            cache.mostBytes = std::min<std::uint64_t>(megabytes, 1ull << 40) << 20;
            if (megabytes == 0)
                cache.root.clear();
        }
    }
    return cache;
}

} // namespace ductus
