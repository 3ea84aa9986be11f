// DoodleContent: a filmed scene as a document of a .ductus project: which clip, and what was found out about
// it. Fields: resources/schemas/doodle.schema.json.
#pragma once

#include "doodling/canvas/canvas.h"
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
    std::string digest = {}; // clipDigest() of it; empty: not known
};

class DoodleContent : public DocumentContent
{
public:
    /// \a scene null: nothing is drawn yet. \a packsAnalysis: motion and depth go into the project even if
    /// the cache has them, so that it can be given away; what is in no cache always does.
    DoodleContent(ClipReference clip, std::shared_ptr<const Shot> shot, UnknownMembers unknown = {},
                  std::shared_ptr<const DoodleScene> scene = nullptr, bool packsAnalysis = false)
        : mClip(std::move(clip)), mShot(std::move(shot)),
          mScene(scene ? std::move(scene) : std::make_shared<const DoodleScene>()),
          mUnknown(std::move(unknown)), mPacksAnalysis(packsAnalysis)
    {
    }

    const ClipReference &clip() const { return mClip; }
    /// Never null.
    const std::shared_ptr<const Shot> &shot() const { return mShot; }
    /// What was drawn; never null.
    const std::shared_ptr<const DoodleScene> &scene() const { return mScene; }

    const UnknownMembers &unknown() const { return mUnknown; }
    /// Motion and depth are in the project.
    bool packsAnalysis() const { return mPacksAnalysis; }

    std::string_view kind() const override { return doodleKindName; }
    Result<void> check(const std::string &place) const override;
    OrderedJson toJson(const Uuid &id, BufferPacker &packer) const override;
    std::vector<const UnknownMembers *> unknownMembers() const override;

private:
    ClipReference mClip;
    std::shared_ptr<const Shot> mShot;
    std::shared_ptr<const DoodleScene> mScene;
    UnknownMembers mUnknown;
    bool mPacksAnalysis;
};

/// Bytes that packing the analysis of \a shot adds to a project, before they are compressed.
std::uint64_t packedAnalysisBytes(const Shot &shot);
/// What a project may be packed with: it is read into memory at once.
inline constexpr std::uint64_t mostPackedBytes = 768ull << 20;

/// For ProjectReadOptions::kinds.
DocumentKind doodleKind();

/// The first doodle document of \a project that can be read.
Result<std::shared_ptr<const DoodleContent>> doodleOf(const Project &project);

} // namespace ductus
