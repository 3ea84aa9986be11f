#include "painting/storage/painting_content.h"

#include "painting/scene/painting_check.h"
#include "painting/storage/painting_json.h"
#include "project/container/entry_name.h"

namespace ductus {

namespace {

bool areTextsUtf8(const Painting &painting)
{
    const auto isFine = [](const auto &named) {
        return isValidUtf8(named.name) && named.name.size() <= maxPaintingText;
    };
    for (const Layer *layer : painting.layers())
        if (!isFine(*layer))
            return false;
    return std::ranges::all_of(painting.stacks, isFine) && isFine(painting.sceneStack) &&
           std::ranges::all_of(painting.looks, isFine) &&
           std::ranges::all_of(painting.motionGroups, isFine) &&
           std::ranges::all_of(painting.pictures, isFine);
}

} // namespace

Result<void> PaintingContent::check(const std::string &place) const
{
    const auto refused = [&](const std::string &problem, const std::string &where) {
        return Error{ErrorCode::InvalidArgument, "Writing the project", problem, "",
                     place + (where.empty() ? "" : " (" + where + ")")};
    };
    if (const Result<void> checked = checkPainting(mPainting); !checked)
        return refused(checked.error().problem, checked.error().place);
    if (!areTextsUtf8(mPainting))
        return refused("a name is too long or not UTF-8", "");
    for (const ReferencePicture &picture : mPainting.pictures) {
        const Image &image = *picture.image;
        if (image.width < 1 || image.height < 1 || image.width > maxPictureSide ||
            image.height > maxPictureSide ||
            image.pixels.size() != std::size_t(image.width) * std::size_t(image.height) * 4)
            return refused("a reference picture has no pixels", picture.name);
    }
    return {};
}

OrderedJson PaintingContent::toJson(const Uuid &id, BufferPacker &packer) const
{
    return paintingToJson(mPainting, mUnknown, id, packer);
}

std::vector<const UnknownMembers *> PaintingContent::unknownMembers() const
{
    std::vector<const UnknownMembers *> all;
    for (const auto &[place, members] : mUnknown)
        all.push_back(&members);
    return all;
}

DocumentKind paintingKind()
{
    const auto read = [](const JsonReader &reader, ArrayLoader &arrays) {
        UnknownPaintingMembers unknown;
        Painting painting = paintingFromJson(reader, arrays, unknown);
        return std::make_shared<const PaintingContent>(std::move(painting), std::move(unknown));
    };
    return {paintingKindName, paintingVersion, read};
}

Result<std::shared_ptr<const PaintingContent>> paintingOf(const ProjectDocument &document)
{
    if (auto content = std::dynamic_pointer_cast<const PaintingContent>(document.content))
        return content;
    const std::string attempted = "Opening the document \"" + document.name + "\"";
    if (document.neededVersion > 0)
        return Error{ErrorCode::NewerVersion, attempted,
                     "it needs a version of Ductus that reads " + document.kind + " version " +
                         std::to_string(document.neededVersion),
                     "Install a newer version of Ductus", ""};
    return Error{ErrorCode::Unsupported, attempted, "it is not a painting but of the kind " + document.kind,
                 "Open it in the program that made it", ""};
}

} // namespace ductus
