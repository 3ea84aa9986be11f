#include "project/project_writer.h"

#include "project/container/container_writer.h"
#include "project/container/entry_name.h"
#include "project/documents/sketch_surface_json.h"
#include "project/kept_buffers.h"

#include <new>

namespace ductus {

namespace {

constexpr char attempted[] = "Writing the project";

Error writeError(ErrorCode code, std::string problem, std::string place)
{
    return {code, attempted, std::move(problem), "", std::move(place)};
}

// The original where it says the same, so that white space and the form of numbers of other programs survive.
Result<StoredEntry> jsonEntry(const std::string &name, const std::string &text,
                              const std::optional<StoredEntry> &original)
{
    if (text.size() > ContainerLimits().maxJsonBytes)
        return writeError(ErrorCode::TooLarge, "there are more objects than a document may hold", name);
    if (original && original->name == name) {
        const Result<Bytes> before = unpacked(*original, name);
        if (before) {
            const std::string_view old(reinterpret_cast<const char *>(before->data()), before->size());
            const auto parsedOld = nlohmann::json::parse(old, nullptr, false);
            if (!parsedOld.is_discarded() && parsedOld == nlohmann::json::parse(text))
                return *original;
        }
    }
    return packedEntry(name, asBytes(text));
}

class ProjectWriter
{
public:
    explicit ProjectWriter(const Project &project) : mProject(project) {}

    Result<SerializedProject> write();

private:
    Result<void> addDocument(const ProjectDocument &document);
    Result<StoredEntry> documentEntry(const ProjectDocument &document, const std::string &name);
    Result<StoredEntry> originalEntry(const ProjectDocument &document, const std::string &name);
    void addBuffer(const std::string &hash, std::span<const std::byte> bytes);

    const Project &mProject;
    SerializedProject mResult;
    OrderedJson mRecords = OrderedJson::array();
    std::vector<StoredEntry> mDocumentEntries;
    std::vector<StoredEntry> mPreviews;
    std::uint64_t mArrayBytes = 0;
};

void ProjectWriter::addBuffer(const std::string &hash, std::span<const std::byte> bytes)
{
    if (mResult.buffers.find(hash))
        return;
    if (const StoredEntry *known = mProject.buffers.find(hash)) {
        mResult.buffers.addEntry(*known);
        ++mResult.copiedBuffers;
    } else {
        mResult.buffers.addEntry(packedEntry(bufferEntryName(hash), bytes));
        ++mResult.packedBuffers;
    }
}

// The document as it came, with the buffers it names.
Result<StoredEntry> ProjectWriter::originalEntry(const ProjectDocument &document, const std::string &name)
{
    if (!document.original)
        return writeError(ErrorCode::InvalidArgument, "the document has no content", name);
    if (document.content) { // the buffers of unread documents are among the kept ones
        const Result<Bytes> text = unpacked(*document.original, name);
        if (!text)
            return text.error();
        const std::string_view view(reinterpret_cast<const char *>(text->data()), text->size());
        for (const std::string &hash : mentionedBuffers(view, mProject.buffers))
            addBuffer(hash, {});
    }
    return *document.original;
}

Result<StoredEntry> ProjectWriter::documentEntry(const ProjectDocument &document, const std::string &name)
{
    const bool hasContent = document.sketchSurface || document.content;
    const bool isAsRead = document.content && document.content == document.readContent && document.original;
    if (!hasContent || document.readOnly || isAsRead)
        return originalEntry(document, name);
    if (document.kind != (document.content ? document.content->kind() : sketchSurfaceKind))
        return writeError(ErrorCode::InvalidArgument, "the content is not of the kind of the document", name);
    if (Result<void> checked = document.content ? document.content->check(name)
                                                : checkSketchSurface(*document.sketchSurface, name);
        !checked)
        return checked.error();
    BufferPacker packer;
    const OrderedJson json = document.content
                                 ? document.content->toJson(document.id, packer)
                                 : sketchSurfaceToJson(*document.sketchSurface, document.id, packer);
    for (const auto &[hash, bytes] : packer.buffers()) {
        mArrayBytes += bytes.size();
        addBuffer(hash, bytes);
    }
    if (mArrayBytes > ContainerLimits().maxArrayBytes)
        return writeError(ErrorCode::TooLarge, "the arrays are larger than a project may hold", name);
    return jsonEntry(name, jsonText(json, 2), document.original);
}

Result<void> ProjectWriter::addDocument(const ProjectDocument &document)
{
    const std::string id = document.id.text();
    const std::string name = document.original ? document.original->name : "documents/" + id + ".json";
    if (!isValidUtf8(document.name) || document.name.size() > ContainerLimits().maxNameLength)
        return writeError(ErrorCode::InvalidArgument, "the name of the document is too long or not UTF-8",
                          name);
    Result<StoredEntry> entry = documentEntry(document, name);
    if (!entry)
        return entry.error();
    mDocumentEntries.push_back(std::move(*entry));
    OrderedJson record = {{"id", id}, {"kind", document.kind}, {"name", document.name}, {"entry", name}};
    if (document.preview) {
        mPreviews.push_back(*document.preview);
        mPreviews.back().name = "previews/" + id + ".png";
        record["preview"] = mPreviews.back().name;
    }
    addUnknown(record, document.unknown);
    mRecords.push_back(std::move(record));
    return {};
}

Result<SerializedProject> ProjectWriter::write()
{
    if (mProject.readOnly)
        return writeError(ErrorCode::NewerVersion,
                          "it was made by a newer version of Ductus and may only be read", "");
    if (!isValidUtf8(mProject.generator) || mProject.documents.size() > ContainerLimits().maxDocuments)
        return writeError(ErrorCode::InvalidArgument,
                          "the generator is not UTF-8, or there are too many documents", "");
    for (const ProjectDocument &document : mProject.documents) {
        if (Result<void> added = addDocument(document); !added)
            return added.error();
    }
    for (const std::string &hash : mProject.keptBuffers) {
        const StoredEntry *entry = mProject.buffers.find(hash);
        if (entry && !mResult.buffers.find(hash)) {
            mResult.buffers.addEntry(*entry);
            ++mResult.copiedBuffers;
        }
    }
    OrderedJson json = {{"schema", projectSchema},  {"version", projectVersion},
                        {"minReader", 1},           {"generator", mProject.generator},
                        {"id", mProject.id.text()}, {"documents", std::move(mRecords)}};
    addUnknown(json, mProject.unknown);
    Result<StoredEntry> projectEntry = jsonEntry("project.json", jsonText(json, 3), mProject.original);
    if (!projectEntry)
        return projectEntry.error();

    std::vector<StoredEntry> entries;
    if (mProject.thumbnail) {
        entries.push_back(*mProject.thumbnail);
        entries.back().name = "thumbnail.png";
    }
    entries.push_back(std::move(*projectEntry));
    entries.insert(entries.end(), mDocumentEntries.begin(), mDocumentEntries.end());
    entries.insert(entries.end(), mPreviews.begin(), mPreviews.end());
    for (const auto &[hash, entry] : mResult.buffers.entries())
        entries.push_back(entry);
    for (const auto &[name, entry] : mProject.keptEntries)
        entries.push_back(entry);
    Result<Bytes> bytes = writtenContainer(entries);
    if (!bytes)
        return bytes.error();
    mResult.bytes = std::move(*bytes);
    return std::move(mResult);
}

} // namespace

Result<SerializedProject> serializedProject(const Project &project)
try {
    return ProjectWriter(project).write();
} catch (const nlohmann::json::exception &error) { // text that is not UTF-8
    return writeError(ErrorCode::InvalidArgument, error.what(), "");
} catch (const std::bad_alloc &) {
    return writeError(ErrorCode::TooLarge, "there is not enough memory to write the project", "");
}

} // namespace ductus
