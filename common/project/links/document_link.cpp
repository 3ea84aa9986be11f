#include "project/links/document_link.h"

#include "project/container/entry_name.h"

#include <algorithm>

namespace ductus {

namespace {

constexpr std::size_t longestFile = 4096;
constexpr std::size_t longestName = 4096;
constexpr std::size_t digestLength = 64;

bool isDigest(const std::string &text)
{
    return text.size() == digestLength &&
           std::ranges::all_of(text, [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

} // namespace

OrderedJson linkJson(const DocumentLink &link)
{
    OrderedJson json = OrderedJson::object();
    if (!link.file.empty())
        json["file"] = link.file;
    json["document"] = link.document.text();
    json["name"] = link.name;
    json["sha256"] = link.digest;
    return json;
}

DocumentLink linkFromJson(const JsonReader &reader)
{
    DocumentLink link;
    if (reader.has("file"))
        link.file = reader.string("file", longestFile);
    const std::optional<Uuid> id = Uuid::parse(reader.string("document", 64));
    if (id)
        link.document = *id;
    else
        reader.failAt("document", "this is no id of a document");
    link.name = reader.string("name", longestName);
    link.digest = reader.string("sha256", digestLength);
    if (!isDigest(link.digest))
        reader.failAt("sha256", "this is no SHA-256");
    return link;
}

std::string linkProblem(const DocumentLink &link)
{
    if (!isValidUtf8(link.file) || link.file.size() > longestFile)
        return "the file a link points to has a name that is too long or not UTF-8";
    if (!isValidUtf8(link.name) || link.name.size() > longestName)
        return "the name of a linked document is too long or not UTF-8";
    if (!isDigest(link.digest))
        return "a link has no SHA-256";
    return {};
}

std::string linkedFileName(const std::filesystem::path &file, const std::filesystem::path &folder)
{
    std::error_code failed;
    const std::filesystem::path whole = std::filesystem::weakly_canonical(file, failed);
    if (failed)
        return file.generic_string();
    if (folder.empty())
        return whole.generic_string();
    const std::filesystem::path from = std::filesystem::weakly_canonical(folder, failed);
    const std::filesystem::path seen = failed ? std::filesystem::path() : whole.lexically_relative(from);
    return seen.empty() ? whole.generic_string() : seen.generic_string();
}

} // namespace ductus
