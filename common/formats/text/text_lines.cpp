#include "formats/text/text_lines.h"

#include "formats/atomic_file.h"
#include "formats/text/number_text.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace ductus {

namespace {

constexpr std::size_t chunkSize = std::size_t(256) << 10;
constexpr std::size_t headSize = std::size_t(64) << 10;
// Longer than any OBJ "l" record met; a binary file without line ends must not be swallowed whole.
constexpr std::size_t longestLine = std::size_t(16) << 20;

} // namespace

std::string_view Words::next()
{
    const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; };
    std::size_t begin = 0;
    while (begin < mRest.size() && isBlank(mRest[begin]))
        ++begin;
    std::size_t end = begin;
    while (end < mRest.size() && !isBlank(mRest[end]))
        ++end;
    const std::string_view word = mRest.substr(begin, end - begin);
    mRest.remove_prefix(end);
    return word;
}

struct TextLines::Stream
{
    int file = -1;
    bool atEnd = false;
    std::string buffer; // mRest points into it

    ~Stream()
    {
        if (file >= 0)
            ::close(file);
    }
};

TextLines::TextLines(std::string_view text, std::string name, std::string attempted)
    : mRest(text), mName(std::move(name)), mAttempted(std::move(attempted)), mSize(text.size())
{
}

TextLines::TextLines(TextLines &&) noexcept = default;
TextLines::~TextLines() = default;

Result<TextLines> TextLines::open(const std::filesystem::path &path, std::string attempted)
{
    const auto failed = [&](int reason) {
        return systemErrorFor(reason, path, attempted, ErrorCode::ReadFailed);
    };
    TextLines lines;
    lines.mStream = std::make_unique<Stream>();
    // O_NONBLOCK: opening a pipe nobody writes to must not hang.
    lines.mStream->file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (lines.mStream->file < 0)
        return failed(errno);
    struct stat status = {};
    if (::fstat(lines.mStream->file, &status) != 0)
        return failed(errno);
    if (S_ISDIR(status.st_mode))
        return failed(EISDIR);
    if (!S_ISREG(status.st_mode))
        return Error{ErrorCode::NotAFile, attempted, "this is a device or a pipe, not a file",
                     "Give the path of a file", path.string()};
    lines.mSize = std::uint64_t(status.st_size);
    lines.mName = path.filename().string();
    lines.mAttempted = std::move(attempted);
    return lines;
}

bool TextLines::refill()
{
    if (!mStream || mStream->atEnd || mFailure)
        return false;
    std::string &buffer = mStream->buffer;
    const std::size_t kept = mRest.size();
    if (kept > longestLine) {
        ++mLineNumber;
        mFailure =
            error(ErrorCode::Malformed, "a line is longer than 16 MB", "Check that this is a text file");
        return false;
    }
    // What is left moves to the front, so the buffer grows only when a line is longer than it.
    if (kept > 0)
        std::memmove(buffer.data(), mRest.data(), kept);
    if (buffer.size() < kept + chunkSize)
        buffer.resize(std::max(kept + chunkSize, 2 * kept));
    std::size_t filled = kept;
    while (filled < buffer.size()) {
        const ssize_t got = ::read(mStream->file, buffer.data() + filled, buffer.size() - filled);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0) {
            mFailure = systemErrorFor(errno, mName, mAttempted, ErrorCode::ReadFailed);
            return false;
        }
        if (got == 0) {
            mStream->atEnd = true;
            break;
        }
        filled += std::size_t(got);
    }
    mRest = std::string_view(buffer).substr(0, filled);
    return filled > kept;
}

std::string_view TextLines::head()
{
    if (mRest.empty())
        refill();
    return mRest.substr(0, headSize);
}

bool TextLines::nextPlain(std::string_view &line)
{
    if (mFailure)
        return false;
    if (mRest.empty())
        refill();
    if (mAtStart) {
        mAtStart = false;
        if (mRest.starts_with("\xEF\xBB\xBF"))
            mRest.remove_prefix(3);
        if (mRest.starts_with("\xFF\xFE") || mRest.starts_with("\xFE\xFF")) {
            mFailure =
                fileError(ErrorCode::Malformed, "the text is UTF-16", "Save it as UTF-8 or plain ASCII");
            return false;
        }
    }
    std::size_t searched = 0;
    std::size_t end = mRest.find_first_of("\r\n");
    // A '\r' that ends what is loaded may be the first half of "\r\n": look further before deciding.
    while (end == std::string_view::npos || (mRest[end] == '\r' && end + 1 == mRest.size())) {
        searched = mRest.size();
        if (!refill())
            break;
        if (end == std::string_view::npos)
            end = mRest.find_first_of("\r\n", searched);
    }
    if (mFailure || mRest.empty())
        return false;
    ++mLineNumber;
    mLastLineIsOpen = end == std::string_view::npos;
    line = mRest.substr(0, end);
    std::size_t used = line.size();
    if (!mLastLineIsOpen)
        used += mRest.substr(end).starts_with("\r\n") ? 2 : 1;
    mRest.remove_prefix(used);
    mGivenOut += used;
    if (std::memchr(line.data(), 0, line.size())) {
        mFailure = error(ErrorCode::Malformed, "there are zero bytes: this is binary data, not text",
                         "Check that the file is of the kind its name says");
        return false;
    }
    return true;
}

bool TextLines::next(std::string_view &line, bool joinContinued)
{
    if (!nextPlain(line))
        return false;
    if (!joinContinued || !line.ends_with('\\'))
        return true;
    mJoined.assign(line.substr(0, line.size() - 1));
    while (nextPlain(line)) {
        const bool goesOn = line.ends_with('\\');
        mJoined.append(1, ' ').append(line.substr(0, line.size() - (goesOn ? 1 : 0)));
        if (mJoined.size() > longestLine) {
            mFailure =
                error(ErrorCode::Malformed, "a line is longer than 16 MB", "Check that this is a text file");
            break;
        }
        if (!goesOn)
            break;
    }
    line = mJoined;
    return !mFailure;
}

double TextLines::fraction() const
{
    return mSize > 0 ? std::min(1.0, double(mGivenOut) / double(mSize)) : 1.0;
}

std::string TextLines::place(std::int64_t line) const
{
    return mName + ":" + std::to_string(line);
}

Error TextLines::error(ErrorCode code, std::string problem, std::string remedy) const
{
    return {code, mAttempted, std::move(problem), std::move(remedy), place()};
}

Error TextLines::fileError(ErrorCode code, std::string problem, std::string remedy) const
{
    return {code, mAttempted, std::move(problem), std::move(remedy), mName};
}

std::optional<Error> TextLines::tick(const JobControl &control) const
{
    if (mLineNumber % 1024 != 0)
        return std::nullopt;
    if (control.isCancelled())
        return cancelledError(mAttempted);
    control.progress(fraction(), mAttempted);
    return std::nullopt;
}

std::optional<Error> TextLines::readPoint(Words &words, Vec3 &point, const char *what) const
{
    for (int k = 0; k < 3; ++k) {
        const std::string_view word = words.next();
        if (word.empty())
            return error(ErrorCode::Malformed,
                         std::string(what) + " has " + std::to_string(k) + " coordinates instead of 3",
                         mLastLineIsOpen ? "The file seems cut off: copy or export it again"
                                         : "Correct this line or export the file again");
        const NumberFault fault = readNumber(word, point[k]);
        if (fault != NumberFault::None)
            return error(ErrorCode::Malformed,
                         std::string("the ") + "xyz"[k] + " coordinate " + describeFault(fault, word),
                         remedyForFault(fault));
    }
    return std::nullopt;
}

} // namespace ductus
