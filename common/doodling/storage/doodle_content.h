// DoodleContent: a filmed scene as a document of a .ductus project: which clip, and what was found out about
// it. Fields: resources/schemas/doodle.schema.json.
#pragma once

#include "doodling/reconstruction/shot.h"
#include "project/project.h"

namespace ductus {

inline constexpr char doodleKindName[] = "doodle";
inline constexpr int doodleVersion = 1;

/// The clip is not part of the project: it is found by its path, seen from the project's folder where
/// possible.
struct ClipReference
{
    std::string path; // UTF-8, '/' between folders
    int frameCount = 0;
    int width = 0, height = 0; // upright pixels
    double framesPerSecond = 0.0;
};

class DoodleContent : public DocumentContent
{
public:
    DoodleContent(ClipReference clip, std::shared_ptr<const Shot> shot, UnknownMembers unknown = {})
        : mClip(std::move(clip)), mShot(std::move(shot)), mUnknown(std::move(unknown))
    {
    }

    const ClipReference &clip() const { return mClip; }
    /// Never null.
    const std::shared_ptr<const Shot> &shot() const { return mShot; }

    std::string_view kind() const override { return doodleKindName; }
    Result<void> check(const std::string &place) const override;
    OrderedJson toJson(const Uuid &id, BufferPacker &packer) const override;
    std::vector<const UnknownMembers *> unknownMembers() const override { return {&mUnknown}; }

private:
    ClipReference mClip;
    std::shared_ptr<const Shot> mShot;
    UnknownMembers mUnknown;
};

/// For ProjectReadOptions::kinds.
DocumentKind doodleKind();

/// The first doodle document of \a project that can be read.
Result<std::shared_ptr<const DoodleContent>> doodleOf(const Project &project);

} // namespace ductus
