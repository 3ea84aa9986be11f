// DocumentContent: what a document of a kind holds whose model lives in a folder above this one (paintings).
// The folder derives its content and names its kind; reading, versions, buffers and saving are done here.
#pragma once

#include "project/arrays/array_loader.h"
#include "project/arrays/buffer_packer.h"
#include "project/uuid.h"

#include <functional>
#include <memory>

namespace ductus {

class DocumentContent
{
public:
    virtual ~DocumentContent() = default;

    /// The kind of documents that hold it: "painting".
    virtual std::string_view kind() const = 0;
    /// Refuses what a reader would refuse (InvalidArgument, place = \a place and the field).
    virtual Result<void> check(const std::string &place) const = 0;
    /// The JSON of checked content; its arrays are added to \a packer, which this finishes. Called on
    /// workers.
    virtual OrderedJson toJson(const Uuid &id, BufferPacker &packer) const = 0;
    /// All members of its objects that it does not know: buffers they mention are kept.
    virtual std::vector<const UnknownMembers *> unknownMembers() const = 0;
};

/// How documents of a kind are read.
struct DocumentKind
{
    using Read =
        std::function<std::shared_ptr<const DocumentContent>(const JsonReader &reader, ArrayLoader &arrays)>;

    std::string name;
    int version = 1; // newer ones are kept unchanged
    Read read;       // of this version; what is wrong is told through the reader, the result is dropped then
};

} // namespace ductus
