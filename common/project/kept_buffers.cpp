#include "project/kept_buffers.h"

#include "project/container/entry_name.h"

#include <algorithm>

namespace ductus {

namespace {

class MentionFinder
{
public:
    explicit MentionFinder(const std::set<std::string> &candidates) : mCandidates(candidates) {}

    // Looks at every run of 64 or more hex digits.
    void search(std::string_view text)
    {
        std::size_t run = 0;
        for (std::size_t i = 0; i < text.size(); ++i) {
            const char c = text[i];
            run = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') ? run + 1 : 0;
            if (run < 64)
                continue;
            if (const auto found = mCandidates.find(std::string(text.substr(i - 63, 64)));
                found != mCandidates.end())
                mMentioned.insert(*found);
        }
    }

    void search(const UnknownMembers &members)
    {
        for (const auto &[key, text] : members)
            search(text);
    }

    // An entry that cannot be unpacked is kept all the same; then nothing may be dropped.
    void search(const StoredEntry &entry)
    {
        const Result<Bytes> bytes = unpacked(entry, entry.name);
        if (bytes)
            search(std::string_view(reinterpret_cast<const char *>(bytes->data()), bytes->size()));
        else
            mMentioned = mCandidates;
    }

    const std::set<std::string> &mentioned() const { return mMentioned; }

private:
    const std::set<std::string> &mCandidates;
    std::set<std::string> mMentioned;
};

void searchUnknown(const SketchSurfaceDocument &document, MentionFinder &finder)
{
    finder.search(document.unknown);
    finder.search(document.settings.unknown);
    if (document.settings.symmetryPlane)
        finder.search(document.settings.symmetryPlane->unknown);
    for (const auto &[id, members] : document.strokeUnknown)
        finder.search(members);
    if (document.proxy)
        finder.search(document.proxy->unknown);
    if (document.surface) {
        finder.search(document.surface->unknown);
        for (const StoredModel &model : document.surface->models)
            finder.search(model.unknown);
    }
}

} // namespace

std::set<std::string> buffersToKeep(const Project &project, const std::set<std::string> &usedBuffers)
{
    MentionFinder finder(usedBuffers);
    finder.search(project.unknown);
    for (const ProjectDocument &document : project.documents) {
        finder.search(document.unknown);
        const bool isUnread = !document.sketchSurface && !document.content;
        if (document.original && (document.readOnly || isUnread))
            finder.search(*document.original);
        if (document.content) {
            for (const UnknownMembers *members : document.content->unknownMembers())
                finder.search(*members);
        }
        if (document.sketchSurface)
            searchUnknown(*document.sketchSurface, finder);
    }
    for (const auto &[name, entry] : project.keptEntries) {
        if (!name.starts_with("media/") && !name.ends_with(".png")) // these refer to nothing
            finder.search(entry);
    }
    std::set<std::string> kept = finder.mentioned();
    for (const auto &[hash, entry] : project.buffers.entries()) {
        if (!usedBuffers.contains(hash))
            kept.insert(hash);
    }
    return kept;
}

std::set<std::string> mentionedBuffers(std::string_view text, const BufferStore &store)
{
    std::set<std::string> hashes;
    for (const auto &[hash, entry] : store.entries())
        hashes.insert(hash);
    MentionFinder finder(hashes);
    finder.search(text);
    return finder.mentioned();
}

} // namespace ductus
