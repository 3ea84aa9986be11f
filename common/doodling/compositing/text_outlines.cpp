#include "doodling/compositing/text_outlines.h"

#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>
#include <string>

namespace ductus {

namespace {

using Outlines = std::vector<std::vector<Vec2>>;

constexpr int stepsACurve = 8;
constexpr char32_t replacement = 0xfffd;

std::u32string characters(std::string_view text)
{
    std::u32string result;
    for (std::size_t i = 0; i < text.size();) {
        const auto byte = [&](std::size_t k) {
            return i + k < text.size() ? (unsigned char)text[i + k] : 0u;
        };
        const unsigned lead = byte(0);
        const int length = lead < 0x80       ? 1
                           : lead >> 5 == 6  ? 2
                           : lead >> 4 == 14 ? 3
                           : lead >> 3 == 30 ? 4
                                             : 0;
        if (length == 0) {
            result += replacement;
            ++i;
            continue;
        }
        char32_t value = length == 1 ? lead : lead & (0x7fu >> length);
        for (int k = 1; k < length; ++k)
            value = value << 6 | (byte(std::size_t(k)) & 0x3f);
        result += value;
        i += std::size_t(length);
    }
    return result;
}

// FreeType's callbacks; y up in font units.
struct Collector
{
    Outlines outlines;
    Vec2 last = Vec2::Zero();

    static Vec2 at(const FT_Vector *p) { return Vec2(double(p->x), double(p->y)); }
    static int move(const FT_Vector *to, void *user)
    {
        auto &self = *static_cast<Collector *>(user);
        self.outlines.push_back({at(to)});
        self.last = at(to);
        return 0;
    }
    static int line(const FT_Vector *to, void *user)
    {
        auto &self = *static_cast<Collector *>(user);
        self.outlines.back().push_back(at(to));
        self.last = at(to);
        return 0;
    }
    static int conic(const FT_Vector *control, const FT_Vector *to, void *user)
    {
        auto &self = *static_cast<Collector *>(user);
        const Vec2 a = self.last, b = at(control), c = at(to);
        for (int i = 1; i <= stepsACurve; ++i) {
            const double t = double(i) / stepsACurve, s = 1.0 - t;
            self.outlines.back().push_back(s * s * a + 2.0 * s * t * b + t * t * c);
        }
        self.last = c;
        return 0;
    }
    static int cubic(const FT_Vector *first, const FT_Vector *second, const FT_Vector *to, void *user)
    {
        auto &self = *static_cast<Collector *>(user);
        const Vec2 a = self.last, b = at(first), c = at(second), d = at(to);
        for (int i = 1; i <= stepsACurve; ++i) {
            const double t = double(i) / stepsACurve, s = 1.0 - t;
            self.outlines.back().push_back(s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c +
                                           t * t * t * d);
        }
        self.last = d;
        return 0;
    }
};

struct Glyph
{
    Outlines outlines; // y down, the em is 1
    double advance = 0.0;
    const void *font = nullptr;
    unsigned index = 0;
};

std::string fontFile(char32_t character, bool isBold)
{
    FcPattern *pattern = FcPatternCreate();
    FcPatternAddString(pattern, FC_FAMILY, reinterpret_cast<const FcChar8 *>("Noto Sans"));
    FcPatternAddInteger(pattern, FC_WEIGHT, isBold ? FC_WEIGHT_BOLD : FC_WEIGHT_REGULAR);
    FcPatternAddBool(pattern, FC_SCALABLE, FcTrue);
    FcPatternAddBool(pattern, FC_COLOR, FcFalse); // pictures of letters have no outlines
    FcCharSet *wanted = FcCharSetCreate();
    FcCharSetAddChar(wanted, FcChar32(character));
    FcPatternAddCharSet(pattern, FC_CHARSET, wanted);
    FcConfigSubstitute(nullptr, pattern, FcMatchPattern);
    FcDefaultSubstitute(pattern);
    FcResult result = FcResultNoMatch;
    FcPattern *found = FcFontMatch(nullptr, pattern, &result);
    FcChar8 *file = nullptr;
    std::string path;
    if (found && FcPatternGetString(found, FC_FILE, 0, &file) == FcResultMatch)
        path = reinterpret_cast<const char *>(file);
    if (found)
        FcPatternDestroy(found);
    FcCharSetDestroy(wanted);
    FcPatternDestroy(pattern);
    return path;
}

} // namespace

struct TextOutlines::Fonts
{
    std::mutex mutex;
    FT_Library library = nullptr;
    std::map<std::string, FT_Face> faces; // by file; null: cannot be read
    std::map<std::pair<char32_t, bool>, Glyph> glyphs;

    ~Fonts()
    {
        for (const auto &[file, face] : faces)
            if (face)
                FT_Done_Face(face);
        if (library)
            FT_Done_FreeType(library);
    }

    FT_Face face(const std::string &file)
    {
        if (!library && FT_Init_FreeType(&library) != 0)
            library = nullptr;
        const auto [place, isNew] = faces.emplace(file, nullptr);
        if (isNew && library && FT_New_Face(library, file.c_str(), 0, &place->second) != 0)
            place->second = nullptr;
        return place->second;
    }

    Glyph box() const
    {
        Glyph glyph;
        glyph.advance = 0.6;
        glyph.outlines = {{{0.06, 0.0}, {0.54, 0.0}, {0.54, -0.7}, {0.06, -0.7}},
                          {{0.12, -0.06}, {0.12, -0.64}, {0.48, -0.64}, {0.48, -0.06}}};
        return glyph;
    }

    Glyph made(char32_t character, bool isBold)
    {
        FT_Face font = face(fontFile(character, isBold));
        const unsigned index = font ? FT_Get_Char_Index(font, character) : 0;
        if (index == 0 || FT_Load_Glyph(font, index, FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING) != 0 ||
            font->units_per_EM == 0)
            return character == U' ' ? Glyph{{}, 0.3, nullptr, 0} : box();
        const double unit = 1.0 / font->units_per_EM;
        Collector collector;
        const FT_Outline_Funcs functions = {
            Collector::move, Collector::line, Collector::conic, Collector::cubic, 0, 0};
        if (FT_Outline_Decompose(&font->glyph->outline, &functions, &collector) != 0)
            return box();
        Glyph glyph;
        glyph.outlines = std::move(collector.outlines);
        for (std::vector<Vec2> &outline : glyph.outlines)
            for (Vec2 &point : outline)
                point = Vec2(point.x() * unit, -point.y() * unit);
        glyph.advance = double(font->glyph->advance.x) * unit;
        glyph.font = font;
        glyph.index = index;
        return glyph;
    }

    const Glyph &glyph(char32_t character, bool isBold)
    {
        const auto place = glyphs.find({character, isBold});
        if (place != glyphs.end())
            return place->second;
        return glyphs.emplace(std::pair(character, isBold), made(character, isBold)).first->second;
    }

    double kerning(const Glyph &left, const Glyph &right)
    {
        if (!left.font || left.font != right.font)
            return 0.0;
        FT_Face font = static_cast<FT_Face>(const_cast<void *>(left.font));
        FT_Vector shift{};
        if (FT_Get_Kerning(font, left.index, right.index, FT_KERNING_UNSCALED, &shift) != 0)
            return 0.0;
        return double(shift.x) / font->units_per_EM;
    }
};

TextOutlines::TextOutlines() : mFonts(std::make_unique<Fonts>()) {}
TextOutlines::~TextOutlines() = default;

Outlines TextOutlines::of(std::string_view text, bool isBold) const
{
    constexpr double emALine = 1.0 / 1.36;  // the line's height of Noto Sans
    constexpr double baseline = 0.5 + 0.26; // of a line of height 1: small letters in its middle
    const std::lock_guard lock(mFonts->mutex);
    Outlines result;
    std::vector<std::u32string> lines(1);
    for (const char32_t character : characters(text)) {
        if (character == U'\n')
            lines.emplace_back();
        else if (character >= U' ')
            lines.back() += character;
    }
    for (std::size_t l = 0; l < lines.size(); ++l) {
        const std::size_t first = result.size();
        double x = 0.0;
        const Glyph *before = nullptr;
        for (const char32_t character : lines[l]) {
            const Glyph &glyph = mFonts->glyph(character, isBold);
            x += before ? mFonts->kerning(*before, glyph) : 0.0;
            for (std::vector<Vec2> outline : glyph.outlines) {
                for (Vec2 &point : outline)
                    point.x() += x;
                result.push_back(std::move(outline));
            }
            x += glyph.advance;
            before = &glyph;
        }
        const double top = double(l) - 0.5 * double(lines.size());
        for (std::size_t i = first; i < result.size(); ++i)
            for (Vec2 &point : result[i])
                point = Vec2((point.x() - 0.5 * x) * emALine, point.y() * emALine + top + baseline);
    }
    return result;
}

} // namespace ductus
