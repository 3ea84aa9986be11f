// PaintingContent: a painting as a document of a .ductus project, with what it does not know of its JSON.
// Fields: resources/schemas/painting.schema.json.
#pragma once

#include "painting/scene/painting.h"
#include "project/project.h"

namespace ductus {

inline constexpr char paintingKindName[] = "painting";
inline constexpr int paintingVersion = 1;

/// Members of JSON objects this version does not know, by where they stand ("layer:5/properties"). They stay
/// with their object; what stands in a list without ids stays while the list keeps its length, and what
/// belongs to a column of elements while these stay the same.
using UnknownPaintingMembers = std::map<std::string, UnknownMembers>;

class PaintingContent : public DocumentContent
{
public:
    PaintingContent(Painting painting, UnknownPaintingMembers unknown)
        : mPainting(std::move(painting)), mUnknown(std::move(unknown))
    {
    }

    const Painting &painting() const { return mPainting; }
    const UnknownPaintingMembers &unknown() const { return mUnknown; }

    std::string_view kind() const override { return paintingKindName; }
    Result<void> check(const std::string &place) const override;
    OrderedJson toJson(const Uuid &id, BufferPacker &packer) const override;
    std::vector<const UnknownMembers *> unknownMembers() const override;

private:
    Painting mPainting;
    UnknownPaintingMembers mUnknown;
};

/// For ProjectReadOptions::kinds.
DocumentKind paintingKind();

/// The content of \a document. NewerVersion (naming the version) or Unsupported if there is none to read.
Result<std::shared_ptr<const PaintingContent>> paintingOf(const ProjectDocument &document);

} // namespace ductus
