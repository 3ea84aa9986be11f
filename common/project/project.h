// Project: everything a .ductus file holds, as values. Copies share the large parts, so a copy is the
// snapshot a worker saves while the user goes on. What this program does not know is kept as it came.
#pragma once

#include "project/arrays/buffer_store.h"
#include "project/document_content.h"
#include "project/json/raw_json.h"
#include "project/sketch_surface_document.h"
#include "project/uuid.h"

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace ductus {

inline constexpr char projectSchema[] = "project";
inline constexpr int projectVersion = 1;

struct ProjectDocument
{
    Uuid id;
    std::string kind; // "sketch-surface", "painting", "doodle" or one of the future
    std::string name; // for people; UTF-8

    /// The content of a sketch-surface document this version can read, null for all others. To edit, put a
    /// changed copy in its place.
    std::shared_ptr<const SketchSurfaceDocument> sketchSurface;

    /// The content of a document of another kind that ProjectReadOptions::kinds knows, null for all others.
    /// To edit, put a changed copy in its place.
    std::shared_ptr<const DocumentContent> content;
    std::shared_ptr<const DocumentContent> readContent; // what \a original says: saved as it came while equal

    /// Made by a newer version; saved as it came whatever the content is.
    bool readOnly = false;
    /// Greater than zero: the content needs a reader of at least this version and was not read.
    int neededVersion = 0;

    std::optional<StoredEntry> preview;  // a PNG
    std::optional<StoredEntry> original; // the JSON as it was read; empty for new documents
    UnknownMembers unknown;              // of its record in project.json
};

struct Project
{
    Uuid id;
    std::string generator = "Ductus"; // the program that saved last, with its version
    std::vector<ProjectDocument> documents;
    std::optional<StoredEntry> thumbnail; // a PNG of at most 256 pixels

    /// Made by a newer version that allows reading: may be saved under no circumstances.
    bool readOnly = false;
    std::vector<std::string> warnings; // for the message bar

    // Below: what a save needs to copy what did not change.
    BufferStore buffers;               // as read
    std::set<std::string> keptBuffers; // hashes of buffers that things unknown here may refer to
    std::map<std::string, StoredEntry, std::less<>> keptEntries;
    std::optional<StoredEntry> original; // project.json as read
    UnknownMembers unknown;              // of project.json

    ProjectDocument *find(const Uuid &document);
    const ProjectDocument *find(const Uuid &document) const;
};

/// A new document without preview.
ProjectDocument newSketchSurface(const Uuid &id, std::string name, SketchSurfaceDocument content);

/// The same of another kind.
ProjectDocument newDocument(const Uuid &id, std::string name, std::shared_ptr<const DocumentContent> content);

/// The content of \a document; fails with NewerVersion (naming the version) or Unsupported if there is none
/// to read.
Result<std::shared_ptr<const SketchSurfaceDocument>> sketchSurfaceOf(const ProjectDocument &document);

} // namespace ductus
