// A project with one painting whose text may be anything: the container around it is whole, so that damage
// reaches the reader of paintings.
#pragma once

#include "check_readers.h"
#include "painting/scene/painting_check.h"
#include "painting/storage/painting_content.h"
#include "painting/testing/sample_painting.h"
#include "project/project_reader.h"
#include "project/project_writer.h"
#include "project/testing/container_surgery.h"

namespace ductus {

inline const char *const fuzzedPaintingEntry = "documents/aaaaaaaa-bbbb-4ccc-8ddd-eeeeeeeeeeee.json";

inline const Bytes &wholePaintingProject()
{
    static const Bytes bytes = [] {
        Project project;
        project.id = *Uuid::parse("11111111-2222-4333-8444-555555555555");
        project.documents.push_back(newDocument(
            *Uuid::parse("aaaaaaaa-bbbb-4ccc-8ddd-eeeeeeeeeeee"), "scene",
            std::make_shared<const PaintingContent>(samplePainting(1, 2, 3), UnknownPaintingMembers{})));
        return serializedProject(project)->bytes;
    }();
    return bytes;
}

inline std::string wholePaintingText()
{
    return textOf(*readContainer(wholePaintingProject(), "whole")->find(fuzzedPaintingEntry));
}

/// \a text as the painting's document.
inline bool checkPaintingReader(std::string_view text)
{
    static const Container whole = *readContainer(wholePaintingProject(), "whole");
    std::vector<StoredEntry> entries;
    for (const auto &[name, entry] : whole.entries)
        entries.push_back(name == fuzzedPaintingEntry ? packedEntry(name, asBytes(text)) : entry);
    const Result<Bytes> bytes = writtenContainer(entries);
    if (!bytes) {
        checkError(bytes.error());
        return false;
    }
    ProjectReadOptions options;
    options.kinds = {paintingKind()};
    const Result<Project> project = parseProject(*bytes, "fuzz.ductus", options);
    if (!project) {
        checkError(project.error());
        return false;
    }
    DUCTUS_ASSERT(project->documents.size() == 1);
    const auto content = paintingOf(project->documents[0]);
    if (!content) {
        checkError(content.error());
        return false;
    }
    DUCTUS_ASSERT(checkPainting((*content)->painting()).ok());
    // What was read can be written, and is the same then.
    Project again = *project;
    again.documents[0].content =
        std::make_shared<const PaintingContent>((*content)->painting(), (*content)->unknown());
    const Result<SerializedProject> written = serializedProject(again);
    DUCTUS_ASSERT(written.ok());
    const Result<Project> reread = parseProject(written->bytes, "again.ductus", options);
    DUCTUS_ASSERT(reread.ok() && paintingOf(reread->documents[0]).ok());
    return true;
}

} // namespace ductus
