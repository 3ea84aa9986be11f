#include "benchmarks/surfacing/contact_sheet.h"

#include "formats/atomic_file.h"
#include "formats/png_file.h"
#include "geometry/mesh_topology.h"
#include "imaging/region_colours.h"
#include "imaging/surface_picture.h"

#include <algorithm>
#include <cctype>
#include <iostream>
#include <set>

namespace ductus {

namespace {

constexpr int cellWidth = 320, cellHeight = 250, captionHeight = 26, columns = 5;
constexpr int glyphWidth = 5, glyphHeight = 7;
constexpr Rgba paper{255, 255, 255, 255}, ink{32, 36, 44, 255};

struct Glyph
{
    char character;
    int rows[glyphHeight]; // five bits each, leftmost first
};

constexpr Glyph glyphs[] = {
    {'A', {0b01110, 0b10001, 0b10001, 0b11111, 0b10001, 0b10001, 0b10001}},
    {'B', {0b11110, 0b10001, 0b10001, 0b11110, 0b10001, 0b10001, 0b11110}},
    {'C', {0b01110, 0b10001, 0b10000, 0b10000, 0b10000, 0b10001, 0b01110}},
    {'D', {0b11110, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b11110}},
    {'E', {0b11111, 0b10000, 0b10000, 0b11110, 0b10000, 0b10000, 0b11111}},
    {'F', {0b11111, 0b10000, 0b10000, 0b11110, 0b10000, 0b10000, 0b10000}},
    {'G', {0b01110, 0b10001, 0b10000, 0b10111, 0b10001, 0b10001, 0b01110}},
    {'H', {0b10001, 0b10001, 0b10001, 0b11111, 0b10001, 0b10001, 0b10001}},
    {'I', {0b01110, 0b00100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110}},
    {'J', {0b00111, 0b00010, 0b00010, 0b00010, 0b00010, 0b10010, 0b01100}},
    {'K', {0b10001, 0b10010, 0b10100, 0b11000, 0b10100, 0b10010, 0b10001}},
    {'L', {0b10000, 0b10000, 0b10000, 0b10000, 0b10000, 0b10000, 0b11111}},
    {'M', {0b10001, 0b11011, 0b10101, 0b10101, 0b10001, 0b10001, 0b10001}},
    {'N', {0b10001, 0b11001, 0b10101, 0b10011, 0b10001, 0b10001, 0b10001}},
    {'O', {0b01110, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b01110}},
    {'P', {0b11110, 0b10001, 0b10001, 0b11110, 0b10000, 0b10000, 0b10000}},
    {'Q', {0b01110, 0b10001, 0b10001, 0b10001, 0b10101, 0b10010, 0b01101}},
    {'R', {0b11110, 0b10001, 0b10001, 0b11110, 0b10100, 0b10010, 0b10001}},
    {'S', {0b01111, 0b10000, 0b10000, 0b01110, 0b00001, 0b00001, 0b11110}},
    {'T', {0b11111, 0b00100, 0b00100, 0b00100, 0b00100, 0b00100, 0b00100}},
    {'U', {0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b01110}},
    {'V', {0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b01010, 0b00100}},
    {'W', {0b10001, 0b10001, 0b10001, 0b10101, 0b10101, 0b11011, 0b10001}},
    {'X', {0b10001, 0b10001, 0b01010, 0b00100, 0b01010, 0b10001, 0b10001}},
    {'Y', {0b10001, 0b10001, 0b01010, 0b00100, 0b00100, 0b00100, 0b00100}},
    {'Z', {0b11111, 0b00001, 0b00010, 0b00100, 0b01000, 0b10000, 0b11111}},
    {'0', {0b01110, 0b10001, 0b10011, 0b10101, 0b11001, 0b10001, 0b01110}},
    {'1', {0b00100, 0b01100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110}},
    {'2', {0b01110, 0b10001, 0b00001, 0b00110, 0b01000, 0b10000, 0b11111}},
    {'3', {0b11110, 0b00001, 0b00001, 0b01110, 0b00001, 0b00001, 0b11110}},
    {'4', {0b00010, 0b00110, 0b01010, 0b10010, 0b11111, 0b00010, 0b00010}},
    {'5', {0b11111, 0b10000, 0b11110, 0b00001, 0b00001, 0b10001, 0b01110}},
    {'6', {0b01110, 0b10000, 0b10000, 0b11110, 0b10001, 0b10001, 0b01110}},
    {'7', {0b11111, 0b00001, 0b00010, 0b00100, 0b01000, 0b01000, 0b01000}},
    {'8', {0b01110, 0b10001, 0b10001, 0b01110, 0b10001, 0b10001, 0b01110}},
    {'9', {0b01110, 0b10001, 0b10001, 0b01111, 0b00001, 0b00001, 0b01110}},
    {'.', {0b00000, 0b00000, 0b00000, 0b00000, 0b00000, 0b01100, 0b01100}},
    {',', {0b00000, 0b00000, 0b00000, 0b00000, 0b01100, 0b00100, 0b01000}},
    {':', {0b00000, 0b01100, 0b01100, 0b00000, 0b01100, 0b01100, 0b00000}},
    {'-', {0b00000, 0b00000, 0b00000, 0b11111, 0b00000, 0b00000, 0b00000}},
    {'_', {0b00000, 0b00000, 0b00000, 0b00000, 0b00000, 0b00000, 0b11111}},
    {'%', {0b11001, 0b11010, 0b00010, 0b00100, 0b01000, 0b01011, 0b10011}},
    {'(', {0b00010, 0b00100, 0b01000, 0b01000, 0b01000, 0b00100, 0b00010}},
    {')', {0b01000, 0b00100, 0b00010, 0b00010, 0b00010, 0b00100, 0b01000}},
    {'/', {0b00001, 0b00010, 0b00010, 0b00100, 0b01000, 0b01000, 0b10000}},
    {'=', {0b00000, 0b00000, 0b11111, 0b00000, 0b11111, 0b00000, 0b00000}},
    {'+', {0b00000, 0b00100, 0b00100, 0b11111, 0b00100, 0b00100, 0b00000}},
    {'>', {0b01000, 0b00100, 0b00010, 0b00001, 0b00010, 0b00100, 0b01000}},
    {'?', {0b01110, 0b10001, 0b00001, 0b00110, 0b00100, 0b00000, 0b00100}},
};

void writeText(const std::string &text, int left, int top, int mostWidth, Image &image)
{
    int x = left;
    for (char c : text) {
        if (x + glyphWidth > left + mostWidth)
            return;
        const auto upper = char(std::toupper(static_cast<unsigned char>(c)));
        const auto *glyph = std::find_if(std::begin(glyphs), std::end(glyphs),
                                         [&](const Glyph &g) { return g.character == upper; });
        for (int row = 0; glyph != std::end(glyphs) && row < glyphHeight; ++row)
            for (int column = 0; column < glyphWidth; ++column)
                if (glyph->rows[row] >> (glyphWidth - 1 - column) & 1)
                    image.set(x + column, top + row, ink);
        x += glyphWidth + 1;
    }
}

void paste(const Image &picture, int left, int top, Image &onto)
{
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            onto.set(left + x, top + y, picture.at(x, y));
}

std::vector<Rgba> coloursOf(const TriangleMesh &mesh, const std::vector<int> &regions)
{
    std::set<std::pair<int, int>> neighbours;
    int count = 0;
    for (int region : regions)
        count = std::max(count, region + 1);
    for (const MeshEdge &edge : MeshTopology(mesh).edges) {
        if (edge.faceCount != 2)
            continue;
        const int a = regions[std::size_t(edge.faces[0])], b = regions[std::size_t(edge.faces[1])];
        if (a != b)
            neighbours.emplace(std::min(a, b), std::max(a, b));
    }
    const std::vector<int> numbers = assignRegionColours(count, {neighbours.begin(), neighbours.end()});
    std::vector<Rgba> colours;
    for (int region : regions)
        colours.push_back(regionColour(numbers[std::size_t(region)]));
    return colours;
}

} // namespace

void ContactSheet::add(const std::string &caption, const TriangleMesh &mesh,
                       const std::vector<int> &triangleRegions, const StrokeSet &strokes)
{
    if (mFile.empty())
        return;
    PictureScene scene;
    PictureMesh surface;
    surface.mesh = mesh;
    surface.triangleColours = coloursOf(mesh, triangleRegions);
    scene.meshes.push_back(std::move(surface));
    const double diagonal = strokes.box().diagonal();
    for (const Stroke &stroke : strokes.strokes) {
        PictureLine line;
        line.points = stroke.points;
        line.radius = diagonal / 500;
        line.visibleBehind = diagonal / 60;
        scene.lines.push_back(std::move(line));
    }
    PictureOptions options;
    options.width = cellWidth;
    options.height = cellHeight;
    options.zUp = strokes.upAxis == UpAxis::Z;
    mCells.push_back({caption, renderPicture(scene, options)});
}

void ContactSheet::addFailure(const std::string &caption)
{
    if (!mFile.empty())
        mCells.push_back({caption + " - failed", Image(cellWidth, cellHeight, {236, 224, 224, 255})});
}

int ContactSheet::write() const
{
    if (mFile.empty() || mCells.empty())
        return 0;
    const int across = std::min(columns, int(mCells.size()));
    const int down = (int(mCells.size()) + columns - 1) / columns;
    Image sheet(across * cellWidth, down * (cellHeight + captionHeight), paper);
    for (int i = 0; i < int(mCells.size()); ++i) {
        const int left = i % columns * cellWidth, top = i / columns * (cellHeight + captionHeight);
        paste(mCells[std::size_t(i)].picture, left, top, sheet);
        writeText(mCells[std::size_t(i)].caption, left + 8, top + cellHeight + 9, cellWidth - 16, sheet);
    }
    const Result<std::vector<std::byte>> png = encodePng(sheet);
    const Result<void> written =
        png ? writeFileAtomically(mFile, *png, "Writing the pictures") : Result<void>(png.error());
    if (!written)
        std::cerr << "bench_surfacing: " << written.error().message() << "\n";
    return written ? 0 : 1;
}

} // namespace ductus
