#include "project/container/entry_name.h"

#include "project/container/limits.h"

#include <algorithm>

namespace ductus {

namespace {

constexpr std::string_view bufferPrefix = "buffers/";
constexpr std::string_view bufferSuffix = ".bin";

} // namespace

bool isValidUtf8(std::string_view text)
{
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const int extra = lead < 0x80                   ? 0
                          : lead >= 0xc2 && lead < 0xe0 ? 1
                          : lead >= 0xe0 && lead < 0xf0 ? 2
                          : lead >= 0xf0 && lead < 0xf5 ? 3
                                                        : -1;
        if (extra < 0 || i + std::size_t(extra) >= text.size())
            return false;
        unsigned codePoint = extra == 0 ? lead : lead & (0x3fu >> extra);
        for (int k = 1; k <= extra; ++k) {
            const auto byte = static_cast<unsigned char>(text[i + std::size_t(k)]);
            if ((byte & 0xc0) != 0x80)
                return false;
            codePoint = codePoint << 6 | (byte & 0x3fu);
        }
        constexpr unsigned smallest[] = {0, 0x80, 0x800, 0x10000};
        if (codePoint < smallest[extra] || codePoint > 0x10ffff ||
            (codePoint >= 0xd800 && codePoint < 0xe000))
            return false;
        i += std::size_t(extra) + 1;
    }
    return true;
}

std::string entryNameProblem(std::string_view name)
{
    if (name.empty())
        return "an entry has no name";
    if (name.size() > ContainerLimits().maxNameLength)
        return "the name of an entry is too long";
    if (!isValidUtf8(name))
        return "the name of an entry is not UTF-8";
    const auto isBad = [](char c) {
        return static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '\\' || c == ':';
    };
    if (std::any_of(name.begin(), name.end(), isBad))
        return "the name of an entry contains a character that is not allowed";
    if (name.front() == '/')
        return "the name of an entry is an absolute path";
    if (name.back() == '/')
        name.remove_suffix(1);
    for (std::size_t begin = 0; begin <= name.size();) {
        const std::size_t end = std::min(name.find('/', begin), name.size());
        const std::string_view part = name.substr(begin, end - begin);
        if (part.empty() || part == "." || part == "..")
            return "the name of an entry leads out of the container or is not in its simplest form";
        begin = end + 1;
    }
    return {};
}

bool isSha256(std::string_view text)
{
    const auto isHexDigit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
    return text.size() == 64 && std::all_of(text.begin(), text.end(), isHexDigit);
}

std::string bufferEntryName(std::string_view sha256)
{
    return std::string(bufferPrefix).append(sha256).append(bufferSuffix);
}

std::string_view sha256OfBufferEntry(std::string_view name)
{
    if (!name.starts_with(bufferPrefix) || !name.ends_with(bufferSuffix))
        return {};
    name.remove_prefix(bufferPrefix.size());
    if (name.size() < bufferSuffix.size())
        return {};
    name.remove_suffix(bufferSuffix.size());
    return isSha256(name) ? name : std::string_view();
}

} // namespace ductus
