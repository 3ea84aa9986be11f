#include "project/json/raw_json.h"

#include <algorithm>

namespace ductus {

namespace {

// Walks over valid JSON; on anything else it still ends and stays inside the text.
class Scanner
{
public:
    explicit Scanner(std::string_view text) : mText(text) {}

    bool atEnd() const { return mPosition >= mText.size(); }

    void skipSpace()
    {
        while (!atEnd() && std::string_view(" \t\r\n").find(mText[mPosition]) != std::string_view::npos)
            ++mPosition;
    }

    bool take(char c)
    {
        skipSpace();
        if (atEnd() || mText[mPosition] != c)
            return false;
        ++mPosition;
        return true;
    }

    std::string_view takeString()
    {
        skipSpace();
        const std::size_t begin = mPosition;
        skipString();
        return mText.substr(begin, mPosition - begin);
    }

    // A value up to the comma or bracket that ends it.
    std::string_view takeValue()
    {
        skipSpace();
        const std::size_t begin = mPosition;
        int depth = 0;
        while (!atEnd()) {
            const char c = mText[mPosition];
            if (c == '"') {
                skipString();
                continue;
            }
            if (depth == 0 && (c == ',' || c == ']' || c == '}'))
                break;
            depth += (c == '[' || c == '{') - (c == ']' || c == '}');
            ++mPosition;
        }
        std::size_t end = mPosition;
        while (end > begin && std::string_view(" \t\r\n").find(mText[end - 1]) != std::string_view::npos)
            --end;
        return mText.substr(begin, end - begin);
    }

private:
    void skipString()
    {
        ++mPosition; // the opening quote
        while (!atEnd() && mText[mPosition] != '"')
            mPosition += mText[mPosition] == '\\' ? 2 : 1;
        mPosition = std::min(mPosition + 1, mText.size());
    }

    std::string_view mText;
    std::size_t mPosition = 0;
};

} // namespace

std::size_t jsonDepth(std::string_view text)
{
    std::size_t depth = 0;
    std::size_t deepest = 0;
    bool inString = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inString) {
            i += c == '\\';
            inString = c != '"';
        } else if (c == '"') {
            inString = true;
        } else if (c == '[' || c == '{') {
            deepest = std::max(deepest, ++depth);
        } else if ((c == ']' || c == '}') && depth > 0) {
            --depth;
        }
    }
    return deepest;
}

std::vector<RawMember> rawMembers(std::string_view text)
{
    std::vector<RawMember> members;
    Scanner scanner(text);
    if (!scanner.take('{') || scanner.take('}'))
        return members;
    do {
        const std::string_view key = scanner.takeString();
        if (!scanner.take(':'))
            break;
        members.push_back({key, scanner.takeValue()});
    } while (scanner.take(','));
    return members;
}

std::vector<std::string_view> rawElements(std::string_view text)
{
    std::vector<std::string_view> elements;
    Scanner scanner(text);
    if (!scanner.take('[') || scanner.take(']'))
        return elements;
    do {
        elements.push_back(scanner.takeValue());
    } while (scanner.take(','));
    return elements;
}

} // namespace ductus
