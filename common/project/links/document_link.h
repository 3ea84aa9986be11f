// DocumentLink: what something was made from: a surface in a painting from a sketch, a painting in a film
// from a painting. What was taken stays where it is; the link tells when there is something newer to take.
#pragma once

#include "project/json/json_reader.h"
#include "project/json/json_writer.h"
#include "project/uuid.h"

#include <filesystem>
#include <string>

namespace ductus {

struct DocumentLink
{
    /// The project it is in: UTF-8, '/' between folders, absolute or as seen from the folder of the project
    /// with the link. Empty: the same project.
    std::string file;
    Uuid document;
    std::string name;   // of the document when it was taken, for people
    std::string digest; // SHA-256 of what was taken, 64 hex digits

    /// Whether both come from the same document, however it looked.
    bool isOfSameDocument(const DocumentLink &other) const
    {
        return document == other.document && file == other.file;
    }
    bool operator==(const DocumentLink &) const = default;
};

OrderedJson linkJson(const DocumentLink &link);
/// What is wrong is told through \a reader.
DocumentLink linkFromJson(const JsonReader &reader);
/// What a reader would refuse, in words; empty: nothing.
std::string linkProblem(const DocumentLink &link);

/// DocumentLink::file for the project \a file, seen from \a folder; absolute if \a folder is empty or has no
/// way to it.
std::string linkedFileName(const std::filesystem::path &file, const std::filesystem::path &folder);

} // namespace ductus
