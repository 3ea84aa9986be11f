#include "formats/sketch_file.h"

#include "formats/sketches/sketch_readers.h"
#include "formats/text/number_text.h"
#include "formats/text/text_lines.h"

#include <algorithm>
#include <new>

namespace ductus {

namespace {

const char *const readingTheSketch = "Reading the sketch";

bool hasExtension(const std::string &name, std::string_view extension)
{
    std::string end = std::filesystem::path(name).extension().string();
    std::transform(end.begin(), end.end(), end.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    return end == extension;
}

/// Files people mix up with sketches get a message of their own.
std::optional<Error> refuseOtherFiles(const TextLines &lines, std::string_view head)
{
    struct Known
    {
        std::string_view magic;
        const char *what;
        const char *remedy;
    };
    static constexpr const char *asProxy =
        "Give it as the proxy (--proxy), and the sketch as .curves, OBJ or xyz";
    static constexpr const char *asSketch = "Give the sketch as .curves, OBJ with 'l' records or x y z text";
    static constexpr Known known[] = {
        {"ply\n", "this is a PLY mesh", asProxy},
        {"ply\r", "this is a PLY mesh", asProxy},
        {"glTF", "this is a GLB scene", asProxy},
        {"OFF", "this is an OFF mesh", asProxy},
        {"COFF", "this is an OFF mesh", asProxy},
        {"solid", "this is an STL mesh", asProxy},
        {"PK\x03\x04", "this is a zip archive", asSketch},
        {"\x89PNG", "this is a PNG picture", asSketch},
        {"{", "this is JSON", asSketch},
        {"[", "this is JSON", asSketch},
    };
    for (const Known &k : known)
        if (head.starts_with(k.magic))
            return lines.fileError(ErrorCode::Unsupported, k.what, k.remedy);
    return std::nullopt;
}

bool isNumber(std::string_view word)
{
    double value = 0.0;
    return readNumber(word, value) != NumberFault::NotANumber;
}

/// The kind the first lines show, or nothing if they are all comments.
std::optional<SketchFileKind> kindFromContent(std::string_view head, const std::string &name)
{
    TextLines lines(head, name, readingTheSketch);
    std::string_view line;
    while (lines.next(line)) {
        Words words(line);
        const std::string_view first = words.next();
        const std::string_view second = words.next();
        if (first.empty() || first[0] == '#')
            continue;
        if (first == "CURVE")
            return SketchFileKind::CurveText;
        // "v 14" announces points, "v 0.1 0.2 0.3" is a vertex; what is neither goes by the name.
        std::int64_t count = 0;
        if (first == "v" && words.next().empty() &&
            (readInteger(second, count) == NumberFault::None || hasExtension(name, ".curves")))
            return SketchFileKind::Curves;
        if (isNumber(first))
            return SketchFileKind::Xyz;
        return hasExtension(name, ".curves") && first != "v" ? SketchFileKind::Curves
                                                             : SketchFileKind::ObjLines;
    }
    return std::nullopt;
}

Result<SketchFile> readAnySketch(TextLines &lines, const SketchReadOptions &options,
                                 const JobControl &control)
{
    const std::string_view head = lines.head();
    if (head.empty() && lines.failure())
        return *lines.failure();
    if (head.empty())
        return lines.fileError(ErrorCode::TooLittleData, "the file is empty", "Export the sketch again");
    if (const auto error = refuseOtherFiles(lines, head))
        return *error;
    const std::optional<SketchFileKind> kind = kindFromContent(head, lines.name());
    if (kind == SketchFileKind::Curves || (!kind && hasExtension(lines.name(), ".curves")))
        return readCurves(lines, options, control);
    if (kind == SketchFileKind::CurveText)
        return readCurveText(lines, options, control);
    if (kind == SketchFileKind::ObjLines || (!kind && hasExtension(lines.name(), ".obj")))
        return readObjLines(lines, options, control);
    return readXyz(lines, options, control);
}

Result<SketchFile> guarded(TextLines &lines, const SketchReadOptions &options, const JobControl &control)
{
    try {
        return readAnySketch(lines, options, control);
    } catch (const std::bad_alloc &) {
        return lines.fileError(ErrorCode::TooLarge, "the memory does not suffice for it",
                               "Thin the sketch out");
    }
}

} // namespace

Result<SketchFile> readSketch(const std::filesystem::path &path, const SketchReadOptions &options,
                              const JobControl &control)
{
    Result<TextLines> lines = TextLines::open(path, readingTheSketch);
    if (!lines)
        return lines.error();
    return guarded(*lines, options, control);
}

Result<SketchFile> parseSketch(std::string_view bytes, const std::string &name,
                               const SketchReadOptions &options, const JobControl &control)
{
    TextLines lines(bytes, name, readingTheSketch);
    return guarded(lines, options, control);
}

} // namespace ductus
