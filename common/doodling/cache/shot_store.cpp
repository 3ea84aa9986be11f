#include "doodling/cache/shot_store.h"

#include <cstdio>

namespace ductus {

namespace {

const char *nameOf(RecordKind kind)
{
    switch (kind) {
    case RecordKind::Motion:
        return "motion";
    case RecordKind::Cameras:
        return "cameras";
    case RecordKind::Moving:
        return "moving";
    case RecordKind::Still:
        return "still";
    case RecordKind::Depth:
        break;
    }
    return "depth";
}

} // namespace

Result<ShotStore> ShotStore::open(const AnalysisCache &cache, const std::string &key)
{
    Result<std::filesystem::path> folder = cache.folder(key);
    if (!folder)
        return folder.error();
    ShotStore store;
    store.mFolder = std::move(*folder);
    return store;
}

std::filesystem::path ShotStore::folderOf(RecordKind kind) const
{
    if (kind == RecordKind::Motion || kind == RecordKind::Cameras)
        return mFolder / nameOf(kind);
    return mFolder / (std::string(nameOf(kind)) + "-" + mCameraKey.substr(0, 16));
}

std::filesystem::path ShotStore::pathOf(RecordKind kind, int frame) const
{
    char name[32];
    std::snprintf(name, sizeof name, "%06d.rec", frame);
    return folderOf(kind) / name;
}

std::shared_ptr<const MappedFile> ShotStore::read(RecordKind kind, int frame)
{
    const Result<std::shared_ptr<const MappedFile>> file = MappedFile::open(pathOf(kind, frame));
    if (!file)
        return nullptr;
    if (!RecordReader(*file).isSound()) {
        refuse(kind, frame);
        return nullptr;
    }
    return *file;
}

Result<std::shared_ptr<const MappedFile>> ShotStore::write(RecordKind kind, int frame,
                                                           const RecordWriter &record)
{
    std::error_code failure;
    std::filesystem::create_directories(folderOf(kind), failure); // write tells what is wrong
    const std::filesystem::path path = pathOf(kind, frame);
    if (Result<void> written = record.write(path); !written)
        return written.error();
    Result<std::shared_ptr<const MappedFile>> file = MappedFile::open(path);
    if (!file) { // removed at once by somebody else
        Error error = file.error();
        error.code = ErrorCode::WriteFailed;
        return error;
    }
    return file;
}

void ShotStore::refuse(RecordKind kind, int frame)
{
    ++mDamagedCount;
    std::error_code failure;
    std::filesystem::remove(pathOf(kind, frame), failure); // it is written anew
}

void ShotStore::removeAll(RecordKind kind)
{
    std::error_code failure;
    std::filesystem::remove_all(folderOf(kind), failure);
}

} // namespace ductus
