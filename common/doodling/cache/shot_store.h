// The records of one clip: what reconstructShot finds is put here frame by frame, and what an earlier run
// left is taken from here, so that an analysis that was stopped goes on where it was.
#pragma once

#include "doodling/cache/analysis_cache.h"
#include "doodling/cache/record.h"

namespace ductus {

enum class RecordKind { Motion, Cameras, Moving, Still, Depth };

class ShotStore
{
public:
    /// \a key of clip and options.
    static Result<ShotStore> open(const AnalysisCache &cache, const std::string &key);

    /// Records that depend on cameras are kept apart from those of other cameras.
    void setCameraKey(const std::string &key) { mCameraKey = key; }

    /// Null if there is none; damaged ones are removed and counted.
    std::shared_ptr<const MappedFile> read(RecordKind kind, int frame);
    /// WriteFailed, whatever the reason.
    Result<std::shared_ptr<const MappedFile>> write(RecordKind kind, int frame, const RecordWriter &record);
    /// Counts the record as damaged: its sum is right but what is in it is not.
    void refuse(RecordKind kind, int frame);
    /// Records of \a kind are not needed any more.
    void removeAll(RecordKind kind);

    int damagedCount() const { return mDamagedCount; }

private:
    std::filesystem::path folderOf(RecordKind kind) const;
    std::filesystem::path pathOf(RecordKind kind, int frame) const;

    std::filesystem::path mFolder;
    std::string mCameraKey = "none";
    int mDamagedCount = 0;
};

} // namespace ductus
