#include "project/project_reader.h"

#include "formats/atomic_file.h"
#include "project/arrays/array_loader.h"
#include "project/container/container_reader.h"
#include "project/container/entry_name.h"
#include "project/documents/sketch_surface_json.h"
#include "project/kept_buffers.h"
#include "project/versioned_json.h"

#include <new>

namespace ductus {

namespace {

constexpr char attempted[] = "Reading the project";

Result<std::string> entryText(const StoredEntry &entry, const std::string &place)
{
    if (entry.size > ContainerLimits().maxJsonBytes)
        return Error{ErrorCode::TooLarge, attempted, "the JSON text is too large", "", place};
    const Result<Bytes> bytes = unpacked(entry, place);
    if (!bytes)
        return bytes.error();
    return std::string(reinterpret_cast<const char *>(bytes->data()), bytes->size());
}

// Everything parseProject() needs at hand while it goes through the entries.
class ProjectParser
{
public:
    ProjectParser(Container container, std::string name, const MigrationTable &migrations,
                  const std::vector<DocumentKind> &kinds)
        : mContainer(std::move(container)), mName(std::move(name)), mMigrations(migrations), mKinds(kinds),
          mArrays(mProject.buffers, mName)
    {
    }

    Result<Project> parse();

private:
    Result<void> readProjectJson();
    Result<void> readDocument(const JsonReader &record);
    Result<void> readContent(ProjectDocument &document, int version,
                             const std::function<void(const JsonReader &)> &read);
    Result<void> readKnownKind(ProjectDocument &document);
    std::optional<StoredEntry> take(const std::string &entryName);
    void takeBuffers();

    Container mContainer; // entries are taken out one by one, the rest is kept
    std::string mName;
    const MigrationTable &mMigrations;
    const std::vector<DocumentKind> &mKinds;
    Project mProject;
    ArrayLoader mArrays;
    std::set<Uuid> mIds;
};

std::optional<StoredEntry> ProjectParser::take(const std::string &entryName)
{
    const auto found = mContainer.entries.find(entryName);
    if (found == mContainer.entries.end())
        return std::nullopt;
    StoredEntry entry = std::move(found->second);
    mContainer.entries.erase(found);
    return entry;
}

void ProjectParser::takeBuffers()
{
    for (auto entry = mContainer.entries.begin(); entry != mContainer.entries.end();) {
        const bool isBuffer = mProject.buffers.addEntry(entry->second);
        entry = isBuffer ? mContainer.entries.erase(entry) : std::next(entry);
    }
}

Result<void> ProjectParser::readContent(ProjectDocument &document, int version,
                                        const std::function<void(const JsonReader &)> &read)
{
    const std::string place = mName + ":" + document.original->name;
    Result<std::string> text = entryText(*document.original, place);
    if (!text)
        return text.error();
    const Result<VersionedJson> json =
        parsedVersionedJson(std::move(*text), document.kind, version, mMigrations, place);
    if (!json)
        return json.error();
    document.readOnly = json->isNewer;
    document.neededVersion = json->neededVersion;
    if (json->isNewer)
        mProject.warnings.push_back(
            "The document \"" + document.name + "\" was made by a newer version of Ductus (" + document.kind +
            " version " + std::to_string(json->fileVersion) + ") and cannot be changed here.");
    if (json->neededVersion > 0)
        return {};
    const JsonReader reader(json->json, place);
    if (reader.string("id", 36) != document.id.text())
        reader.failAt("id", "this is not the document project.json speaks of");
    read(reader);
    if (reader.failed())
        return reader.error();
    return {};
}

Result<void> ProjectParser::readKnownKind(ProjectDocument &document)
{
    if (document.kind == sketchSurfaceKind)
        return readContent(document, sketchSurfaceVersion, [&](const JsonReader &reader) {
            document.sketchSurface =
                std::make_shared<const SketchSurfaceDocument>(sketchSurfaceFromJson(reader, mArrays));
        });
    for (const DocumentKind &kind : mKinds) {
        if (kind.name == document.kind)
            return readContent(document, kind.version, [&](const JsonReader &reader) {
                document.content = document.readContent = kind.read(reader, mArrays);
            });
    }
    return {};
}

Result<void> ProjectParser::readDocument(const JsonReader &record)
{
    const ContainerLimits limits;
    ProjectDocument document;
    const std::optional<Uuid> id = Uuid::parse(record.string("id", 36));
    document.kind = record.string("kind", 64);
    document.name = record.string("name", limits.maxNameLength);
    const std::string entryName = record.string("entry", limits.maxNameLength);
    const std::string previewName =
        record.has("preview") ? record.string("preview", limits.maxNameLength) : "";
    document.unknown = record.unknown({"id", "kind", "name", "entry", "preview"});
    if (!record.failed() && (!id || !mIds.insert(*id).second))
        record.failAt("id", id ? "two documents have the same id" : "this is not an id");
    if (record.failed())
        return record.error();
    document.id = *id;
    document.original = take(entryName);
    if (!document.original) {
        record.failAt("entry", "the project does not hold " + entryName + ", or another document does");
        return record.error();
    }
    if (!previewName.empty())
        document.preview = take(previewName);
    if (Result<void> read = readKnownKind(document); !read)
        return read;
    mProject.documents.push_back(std::move(document));
    return {};
}

Result<void> ProjectParser::readProjectJson()
{
    const std::string place = mName + ":project.json";
    mProject.original = take("project.json");
    if (!mProject.original)
        return Error{ErrorCode::Malformed, attempted, "the entry project.json is missing", "", mName};
    Result<std::string> text = entryText(*mProject.original, place);
    if (!text)
        return text.error();
    const Result<VersionedJson> json =
        parsedVersionedJson(std::move(*text), projectSchema, projectVersion, mMigrations, place);
    if (!json)
        return json.error();
    if (json->neededVersion > 0)
        return Error{ErrorCode::NewerVersion, attempted,
                     "it needs a version of Ductus that reads project version " +
                         std::to_string(json->neededVersion),
                     "Install a newer version of Ductus", place};
    mProject.readOnly = json->isNewer;
    if (json->isNewer)
        mProject.warnings.push_back("This project was made by a newer version of Ductus (project version " +
                                    std::to_string(json->fileVersion) + ") and is opened read-only.");
    const JsonReader reader(json->json, place);
    const std::optional<Uuid> id = Uuid::parse(reader.string("id", 36));
    if (!reader.failed() && !id)
        reader.failAt("id", "this is not an id");
    if (reader.has("generator"))
        mProject.generator = reader.string("generator", ContainerLimits().maxNameLength);
    mProject.unknown = reader.unknown({"schema", "version", "minReader", "generator", "id", "documents"});
    const std::vector<JsonReader> records = reader.elements("documents", ContainerLimits().maxDocuments);
    if (reader.failed())
        return reader.error();
    mProject.id = *id;
    for (const JsonReader &record : records) {
        if (Result<void> read = readDocument(record); !read)
            return read;
    }
    return {};
}

Result<Project> ProjectParser::parse()
{
    mProject.warnings = std::move(mContainer.warnings);
    mProject.thumbnail = take("thumbnail.png");
    takeBuffers();
    if (Result<void> read = readProjectJson(); !read)
        return read.error();
    mProject.keptEntries = std::move(mContainer.entries);
    mProject.keptBuffers = buffersToKeep(mProject, mArrays.usedBuffers());
    return std::move(mProject);
}

} // namespace

Result<Project> parseProject(std::span<const std::byte> bytes, const std::string &name,
                             const ProjectReadOptions &options)
try {
    Result<Container> container = readContainer(bytes, name, options.limits);
    if (!container)
        return container.error();
    return ProjectParser(std::move(*container), name,
                         options.migrations ? *options.migrations : builtInMigrations(), options.kinds)
        .parse();
} catch (const std::bad_alloc &) {
    return Error{ErrorCode::TooLarge, attempted, "there is not enough memory for this file", "", name};
}

Result<Project> openProject(const std::filesystem::path &path, const ProjectReadOptions &options)
{
    const Result<std::string> content = readWholeFile(path, options.limits.maxFileBytes, attempted);
    if (!content)
        return content.error();
    return parseProject(asBytes(*content), path.filename().string(), options);
}

} // namespace ductus
