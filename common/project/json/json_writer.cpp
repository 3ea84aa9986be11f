#include "project/json/json_writer.h"

namespace ductus {

namespace {

// Raw text travels inside the tree as a "binary" value, a kind JSON itself does not have.
OrderedJson rawValue(const std::string &text)
{
    return OrderedJson::binary(std::vector<std::uint8_t>(text.begin(), text.end()));
}

void append(std::string &out, const OrderedJson &value, int level, int openLevels)
{
    if (value.is_binary()) {
        out.append(value.get_binary().begin(), value.get_binary().end());
        return;
    }
    if (!value.is_structured() || value.empty()) {
        out += value.dump();
        return;
    }
    const bool open = level < openLevels;
    const std::string separator = open ? "\n" + std::string(std::size_t(level + 1), ' ') : "";
    out += value.is_object() ? '{' : '[';
    bool first = true;
    for (const auto &[key, member] : value.items()) {
        if (!first)
            out += open ? "," : ", ";
        first = false;
        out += separator;
        if (value.is_object())
            out += OrderedJson(key).dump() + ": ";
        append(out, member, level + 1, openLevels);
    }
    if (open)
        out += "\n" + std::string(std::size_t(level), ' ');
    out += value.is_object() ? '}' : ']';
}

} // namespace

void addUnknown(OrderedJson &object, const UnknownMembers &unknown)
{
    for (const auto &[key, text] : unknown) {
        if (!object.contains(key))
            object[key] = rawValue(text);
    }
}

std::string jsonText(const OrderedJson &value, int openLevels)
{
    std::string out;
    append(out, value, 0, openLevels);
    out += '\n';
    return out;
}

} // namespace ductus
