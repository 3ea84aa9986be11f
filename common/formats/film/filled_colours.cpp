#include "formats/film/filled_colours.h"

#include <algorithm>

namespace ductus {

namespace {

// Sums of colour weighted by alpha; each level has a quarter of the cells of the one below.
struct Level
{
    int width = 0, height = 0;
    std::vector<std::array<float, 4>> cells;
};

Level bottomOf(const Image &image)
{
    Level level{(image.width + 1) / 2, (image.height + 1) / 2, {}};
    level.cells.assign(std::size_t(level.width) * std::size_t(level.height), {0, 0, 0, 0});
    for (int y = 0; y < image.height; ++y) {
        const std::uint8_t *p = image.pixels.data() + 4 * std::size_t(y) * std::size_t(image.width);
        auto *row = level.cells.data() + std::size_t(y / 2) * std::size_t(level.width);
        for (int x = 0; x < image.width; ++x, p += 4)
            if (p[3] != 0) {
                auto &cell = row[x / 2];
                for (std::size_t c = 0; c < 3; ++c)
                    cell[c] += float(p[c]) * float(p[3]);
                cell[3] += float(p[3]);
            }
    }
    return level;
}

Level coarser(const Level &fine)
{
    Level level{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
    level.cells.assign(std::size_t(level.width) * std::size_t(level.height), {0, 0, 0, 0});
    for (int y = 0; y < fine.height; ++y)
        for (int x = 0; x < fine.width; ++x) {
            const auto &from = fine.cells[std::size_t(y) * std::size_t(fine.width) + std::size_t(x)];
            auto &to = level.cells[std::size_t(y / 2) * std::size_t(level.width) + std::size_t(x / 2)];
            for (std::size_t c = 0; c < 4; ++c)
                to[c] += from[c];
        }
    return level;
}

// From the coarsest level down: cells nobody is visible in take the colour above them.
void fillDown(std::vector<Level> &levels)
{
    for (std::size_t l = levels.size() - 1; l-- > 0;) {
        Level &fine = levels[l];
        const Level &above = levels[l + 1];
        for (int y = 0; y < fine.height; ++y)
            for (int x = 0; x < fine.width; ++x) {
                auto &cell = fine.cells[std::size_t(y) * std::size_t(fine.width) + std::size_t(x)];
                if (cell[3] == 0.0f)
                    cell = above.cells[std::size_t(y / 2) * std::size_t(above.width) + std::size_t(x / 2)];
            }
    }
}

} // namespace

Image withFilledColours(const Image &image)
{
    std::vector<Level> levels{bottomOf(image)};
    while (levels.back().width > 1 || levels.back().height > 1)
        levels.push_back(coarser(levels.back()));
    Image result = image;
    if (levels.back().cells.front()[3] == 0.0f)
        return result; // nothing is visible at all
    fillDown(levels);
    const Level &bottom = levels.front();
    for (int y = 0; y < image.height; ++y) {
        std::uint8_t *p = result.pixels.data() + 4 * std::size_t(y) * std::size_t(image.width);
        const auto *row = bottom.cells.data() + std::size_t(y / 2) * std::size_t(bottom.width);
        for (int x = 0; x < image.width; ++x, p += 4)
            if (p[3] == 0)
                for (std::size_t c = 0; c < 3; ++c)
                    p[c] = std::uint8_t(std::clamp(row[x / 2][c] / row[x / 2][3] + 0.5f, 0.0f, 255.0f));
    }
    return result;
}

} // namespace ductus
