#include "doodling/compositing/stickers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ductus {

namespace {

constexpr double pi = std::numbers::pi;
constexpr Rgba ink = {40, 36, 48, 255};
constexpr Rgba white = {255, 255, 255, 255};
constexpr double rim = 0.022; // radius of outlines

Rgba shaded(const Rgba &colour, double share)
{
    Rgba result = colour;
    for (std::size_t c = 0; c < 3; ++c)
        result[c] = std::uint8_t(std::clamp(std::lround(share * colour[c]), 0l, 255l));
    return result;
}

Outline ellipse(const Vec2 &middle, double rx, double ry, double from = 0.0, double to = 2.0 * pi)
{
    Outline points;
    constexpr int count = 48;
    for (int i = 0; i <= count; ++i) {
        const double angle = from + (to - from) * i / count;
        points.emplace_back(middle.x() + rx * std::cos(angle), middle.y() + ry * std::sin(angle));
    }
    return points;
}

LinePiece lines(std::vector<Outline> outlines, double radius, const Rgba &colour)
{
    LinePiece piece;
    piece.colour = colour;
    for (Outline &outline : outlines) {
        const std::size_t count = outline.size();
        piece.lines.push_back({std::move(outline), std::vector<double>(count, radius)});
    }
    return piece;
}

Outline closed(Outline outline)
{
    outline.push_back(outline.front());
    return outline;
}

// Filled, with a darker rim.
std::vector<MarkPiece> body(const Outline &outline, const Rgba &colour)
{
    return {AreaPiece{{outline}, colour}, lines({closed(outline)}, rim, shaded(colour, 0.62))};
}

std::vector<MarkPiece> star(const Rgba &colour)
{
    Outline outline;
    for (int i = 0; i < 10; ++i) {
        const double angle = -0.5 * pi + pi * i / 5.0, radius = i % 2 ? 0.215 : 0.47;
        outline.emplace_back(radius * std::cos(angle), 0.03 + radius * std::sin(angle));
    }
    return body(outline, colour);
}

std::vector<MarkPiece> heart(const Rgba &colour)
{
    Outline outline;
    for (int i = 0; i < 64; ++i) {
        const double t = 2.0 * pi * i / 64.0;
        const double x = 16.0 * std::pow(std::sin(t), 3);
        const double y = 13.0 * std::cos(t) - 5.0 * std::cos(2 * t) - 2.0 * std::cos(3 * t) - std::cos(4 * t);
        outline.emplace_back(x * 0.028, -y * 0.028 - 0.03);
    }
    return body(outline, colour);
}

std::vector<MarkPiece> check(const Rgba &colour)
{
    const Outline line = {{-0.36, 0.04}, {-0.1, 0.32}, {0.38, -0.32}};
    return {lines({line}, 0.095, shaded(colour, 0.62)), lines({line}, 0.075, colour)};
}

std::vector<MarkPiece> cross(const Rgba &colour)
{
    const std::vector<Outline> two = {{{-0.32, -0.32}, {0.32, 0.32}}, {{0.32, -0.32}, {-0.32, 0.32}}};
    return {lines(two, 0.095, shaded(colour, 0.62)), lines(two, 0.075, colour)};
}

std::vector<MarkPiece> face(const Rgba &colour, bool isHappy)
{
    std::vector<MarkPiece> pieces = body(ellipse({0.0, 0.0}, 0.45, 0.45), colour);
    pieces.push_back(AreaPiece{{ellipse({-0.16, -0.1}, 0.05, 0.08), ellipse({0.16, -0.1}, 0.05, 0.08)}, ink});
    const Outline mouth = isHappy ? ellipse({0.0, 0.04}, 0.24, 0.22, 0.12 * pi, 0.88 * pi)
                                  : ellipse({0.0, 0.36}, 0.2, 0.2, 1.15 * pi, 1.85 * pi);
    pieces.push_back(lines({mouth}, 0.03, ink));
    return pieces;
}

std::vector<MarkPiece> ring(const Rgba &colour)
{
    return {lines({ellipse({0.0, 0.0}, 0.42, 0.42)}, 0.05, colour)};
}

std::vector<MarkPiece> bubble(const Rgba &colour)
{
    Outline outline = ellipse({0.0, -0.06}, 0.47, 0.36, 0.62 * pi, 2.46 * pi);
    outline.emplace_back(-0.24, 0.47); // the tail, down to who speaks
    std::vector<MarkPiece> pieces = {AreaPiece{{outline}, white}, lines({closed(outline)}, rim, colour)};
    return pieces;
}

std::vector<MarkPiece> bang(const Rgba &colour)
{
    const Outline stem = {{-0.085, -0.44}, {0.085, -0.44}, {0.045, 0.16}, {-0.045, 0.16}};
    std::vector<MarkPiece> pieces = body(stem, colour);
    for (MarkPiece &piece : body(ellipse({0.0, 0.34}, 0.085, 0.085), colour))
        pieces.push_back(std::move(piece));
    return pieces;
}

std::vector<MarkPiece> question(const Rgba &colour)
{
    Outline hook = ellipse({0.0, -0.2}, 0.2, 0.2, pi, 2.35 * pi);
    hook.emplace_back(0.0, 0.08);
    hook.emplace_back(0.0, 0.17);
    const Outline dot = {{0.0, 0.38}, {0.0, 0.381}};
    return {lines({hook, dot}, 0.095, shaded(colour, 0.62)), lines({hook, dot}, 0.073, colour)};
}

std::vector<MarkPiece> bulb(const Rgba &colour)
{
    Outline glass = ellipse({0.0, -0.1}, 0.29, 0.29, 0.68 * pi, 2.32 * pi);
    glass.emplace_back(0.12, 0.26);
    glass.emplace_back(-0.12, 0.26);
    std::vector<MarkPiece> pieces = body(glass, colour);
    pieces.push_back(lines({{{-0.11, 0.32}, {0.11, 0.32}}, {{-0.08, 0.4}, {0.08, 0.4}}}, 0.03, ink));
    std::vector<Outline> rays;
    for (int i = 0; i < 5; ++i) {
        const double angle = -pi + pi * i / 4.0;
        const Vec2 way(std::cos(angle), std::sin(angle));
        rays.push_back({Vec2(0.0, -0.1) + 0.34 * way, Vec2(0.0, -0.1) + (i == 2 ? 0.365 : 0.41) * way});
    }
    pieces.push_back(lines(std::move(rays), 0.024, shaded(colour, 0.8)));
    return pieces;
}

std::vector<MarkPiece> bolt(const Rgba &colour)
{
    return body({{0.06, -0.47}, {-0.27, 0.07}, {-0.04, 0.07}, {-0.1, 0.47}, {0.27, -0.12}, {0.03, -0.12}},
                colour);
}

using Maker = std::vector<MarkPiece> (*)(const Rgba &);

struct Entry
{
    std::string_view name;
    Maker make;
};

constexpr std::array entries = {
    Entry{"star", star},
    Entry{"heart", heart},
    Entry{"check", check},
    Entry{"cross", cross},
    Entry{"smile", [](const Rgba &colour) { return face(colour, true); }},
    Entry{"frown", [](const Rgba &colour) { return face(colour, false); }},
    Entry{"ring", ring},
    Entry{"bubble", bubble},
    Entry{"bang", bang},
    Entry{"question", question},
    Entry{"bulb", bulb},
    Entry{"bolt", bolt},
};

constexpr auto names = [] {
    std::array<std::string_view, entries.size()> result;
    for (std::size_t i = 0; i < entries.size(); ++i)
        result[i] = entries[i].name;
    return result;
}();

} // namespace

std::span<const std::string_view> stickerNames()
{
    return names;
}

std::vector<MarkPiece> stickerPieces(std::string_view name, const Rgba &colour)
{
    for (const Entry &entry : entries)
        if (entry.name == name)
            return entry.make(colour);
    return question(colour);
}

} // namespace ductus
