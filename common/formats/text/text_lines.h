// TextLines: the one scanner under all text formats. Gives the lines of a file or of memory with their
// numbers; knows \n, \r\n, \r, a byte order mark and a missing last newline; refuses binary data. Files are
// streamed, so a reader that gives up after n points has used memory for n points only.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "geometry/triangle_mesh.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace ductus {

/// The words of a line, split at blanks and tabs.
class Words
{
public:
    explicit Words(std::string_view line) : mRest(line) {}

    /// The next word, or an empty view at the end of the line.
    std::string_view next();

private:
    std::string_view mRest;
};

class TextLines
{
public:
    /// Lines of \a text, which must outlive the object. \a name stands in error messages, \a attempted too.
    TextLines(std::string_view text, std::string name, std::string attempted);

    /// Lines of a file. Says apart: missing, a folder, no permission.
    static Result<TextLines> open(const std::filesystem::path &path, std::string attempted);

    TextLines(TextLines &&) noexcept;
    ~TextLines();

    /// The first bytes of the file (at most 64 KB), without consuming them.
    std::string_view head();

    /// The next line without its end, valid until the next call. False at the end of the file or when reading
    /// failed; failure() tells which. With \a joinContinued a '\' at the end of a line goes on in the next.
    bool next(std::string_view &line, bool joinContinued = false);

    /// 1 for the first line; of a joined line the last.
    std::int64_t lineNumber() const { return mLineNumber; }

    /// True if the last line given had no line end: a hint that the file is cut off.
    bool lastLineIsOpen() const { return mLastLineIsOpen; }

    const std::optional<Error> &failure() const { return mFailure; }

    /// 0..1, how much of the file has been given out.
    double fraction() const;
    /// Bytes given out so far with their line ends: where binary data after a text header begins.
    std::uint64_t bytesGivenOut() const { return mGivenOut; }

    /// "hat.curves:12".
    std::string place() const { return place(mLineNumber); }
    std::string place(std::int64_t line) const;

    const std::string &name() const { return mName; }
    const std::string &attempted() const { return mAttempted; }

    /// An Error at the current line.
    Error error(ErrorCode code, std::string problem, std::string remedy) const;
    /// An Error about the file as a whole.
    Error fileError(ErrorCode code, std::string problem, std::string remedy) const;

    /// The Error that ends reading now, if any: cancelled (asked every 1024 lines, with progress). Called
    /// once a line by every reader.
    std::optional<Error> tick(const JobControl &control) const;

    /// Three numbers from \a words; the Error tells which one is wrong. \a what: "the point", "the vertex".
    std::optional<Error> readPoint(Words &words, Vec3 &point, const char *what) const;

private:
    struct Stream;

    TextLines() = default;
    bool nextPlain(std::string_view &line);
    bool refill();

    std::unique_ptr<Stream> mStream; // null when the text is in memory
    std::string_view mRest;          // what is loaded and not yet given out
    std::string mJoined;
    std::string mName;
    std::string mAttempted;
    std::uint64_t mSize = 0;
    std::uint64_t mGivenOut = 0;
    std::int64_t mLineNumber = 0;
    bool mAtStart = true;
    bool mLastLineIsOpen = false;
    std::optional<Error> mFailure;
};

} // namespace ductus
