#include "formats/film/gif_palette.h"

#include <algorithm>
#include <limits>

namespace ductus {

namespace {

constexpr int bits = 5; // a channel of the histogram
constexpr int mostColours = 255;
constexpr int refinements = 3;

struct Bin
{
    std::array<double, 3> mean{};
    double weight = 0.0;
};

std::vector<Bin> histogram(const Image &image)
{
    std::vector<Bin> all(std::size_t(1) << (3 * bits));
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        const std::uint8_t *p = image.pixels.data() + i;
        if (p[3] < 128)
            continue;
        const std::size_t key =
            std::size_t(p[0] >> 3) << 10 | std::size_t(p[1] >> 3) << 5 | std::size_t(p[2] >> 3);
        Bin &bin = all[key];
        for (std::size_t c = 0; c < 3; ++c)
            bin.mean[c] += p[c];
        bin.weight += 1.0;
    }
    std::erase_if(all, [](const Bin &bin) { return bin.weight == 0.0; });
    for (Bin &bin : all)
        for (double &sum : bin.mean)
            sum /= bin.weight;
    return all;
}

struct Group
{
    std::size_t begin = 0, end = 0; // of the bins
    std::array<double, 3> mean{};
    std::size_t axis = 0; // of greatest scatter
    double scatter = 0.0; // along it, times the weight
};

Group grouped(const std::vector<Bin> &bins, std::size_t begin, std::size_t end)
{
    Group group{begin, end, {}, 0, 0.0};
    double weight = 0.0;
    std::array<double, 3> squares{};
    for (std::size_t i = begin; i < end; ++i) {
        weight += bins[i].weight;
        for (std::size_t c = 0; c < 3; ++c) {
            group.mean[c] += bins[i].weight * bins[i].mean[c];
            squares[c] += bins[i].weight * bins[i].mean[c] * bins[i].mean[c];
        }
    }
    for (std::size_t c = 0; c < 3; ++c) {
        group.mean[c] /= weight;
        const double scatter = squares[c] - weight * group.mean[c] * group.mean[c];
        if (end - begin > 1 && scatter > group.scatter) {
            group.scatter = scatter;
            group.axis = c;
        }
    }
    return group;
}

std::vector<std::array<double, 3>> cut(std::vector<Bin> &bins)
{
    std::vector<Group> groups;
    if (!bins.empty())
        groups.push_back(grouped(bins, 0, bins.size()));
    while (!groups.empty() && groups.size() < mostColours) {
        const auto widest =
            std::max_element(groups.begin(), groups.end(),
                             [](const Group &a, const Group &b) { return a.scatter < b.scatter; });
        if (widest->scatter <= 0.0)
            break;
        const Group whole = *widest;
        const auto first = bins.begin() + std::ptrdiff_t(whole.begin),
                   last = bins.begin() + std::ptrdiff_t(whole.end);
        const auto middle = std::stable_partition(
            first, last, [&](const Bin &bin) { return bin.mean[whole.axis] < whole.mean[whole.axis]; });
        const std::size_t at = std::size_t(middle - bins.begin());
        if (at == whole.begin || at == whole.end) { // equal but for rounding
            widest->scatter = 0.0;
            continue;
        }
        *widest = grouped(bins, whole.begin, at);
        groups.push_back(grouped(bins, at, whole.end));
    }
    std::vector<std::array<double, 3>> means;
    for (const Group &group : groups)
        means.push_back(group.mean);
    return means;
}

double distance(const std::array<double, 3> &a, const std::array<double, 3> &b)
{
    double sum = 0.0;
    for (std::size_t c = 0; c < 3; ++c)
        sum += (a[c] - b[c]) * (a[c] - b[c]);
    return sum;
}

void refine(const std::vector<Bin> &bins, std::vector<std::array<double, 3>> &colours)
{
    std::vector<Bin> sums(colours.size());
    for (const Bin &bin : bins) {
        std::size_t best = 0;
        double least = std::numeric_limits<double>::max();
        for (std::size_t i = 0; i < colours.size(); ++i)
            if (const double d = distance(bin.mean, colours[i]); d < least) {
                least = d;
                best = i;
            }
        for (std::size_t c = 0; c < 3; ++c)
            sums[best].mean[c] += bin.weight * bin.mean[c];
        sums[best].weight += bin.weight;
    }
    for (std::size_t i = 0; i < colours.size(); ++i)
        if (sums[i].weight > 0.0)
            for (std::size_t c = 0; c < 3; ++c)
                colours[i][c] = sums[i].mean[c] / sums[i].weight;
}

// 8 x 8 thresholds 0..63 in Bayer's order.
constexpr int threshold(int x, int y)
{
    int value = 0;
    for (int bit = 0; bit < 3; ++bit) {
        const int xb = (x >> bit) & 1, yb = (y >> bit) & 1;
        value |= ((xb ^ yb) << 1 | yb) << (2 * (2 - bit));
    }
    return value;
}

int channel(std::uint32_t colour, int shift)
{
    return int(colour >> shift & 255u);
}

} // namespace

GifPalette GifPalette::of(const Image &image)
{
    std::vector<Bin> bins = histogram(image);
    std::vector<std::array<double, 3>> colours = cut(bins);
    for (int i = 0; i < refinements && colours.size() == mostColours; ++i)
        refine(bins, colours);
    GifPalette palette;
    palette.mCount = int(colours.size());
    for (std::size_t i = 0; i < colours.size(); ++i) {
        std::uint32_t packed = 0xff;
        for (double value : colours[i])
            packed = packed << 8 | std::uint32_t(std::clamp(value + 0.5, 0.0, 255.0));
        palette.mColours[i] = packed;
    }
    for (std::size_t i = colours.size(); i < transparent; ++i)
        palette.mColours[i] = 0xff000000u;
    palette.mColours[transparent] = 0;
    palette.mCache.assign(std::size_t(1) << 18, -1);
    return palette;
}

int GifPalette::nearest(int r, int g, int b) const
{
    int best = 0, least = std::numeric_limits<int>::max();
    for (int i = 0; i < mCount; ++i) {
        const std::uint32_t colour = mColours[std::size_t(i)];
        const int dr = r - channel(colour, 16), dg = g - channel(colour, 8), db = b - channel(colour, 0);
        if (const int d = dr * dr + dg * dg + db * db; d < least) {
            least = d;
            best = i;
        }
    }
    return best;
}

int GifPalette::nearestCached(int r, int g, int b)
{
    std::int16_t &entry = mCache[std::size_t(r >> 2) << 12 | std::size_t(g >> 2) << 6 | std::size_t(b >> 2)];
    if (entry < 0)
        entry = std::int16_t(nearest((r & ~3) + 2, (g & ~3) + 2, (b & ~3) + 2));
    return entry;
}

double GifPalette::error(const Image &image) const
{
    double sum = 0.0, weight = 0.0;
    for (const Bin &bin : histogram(image)) {
        const auto rounded = [&](std::size_t c) { return int(bin.mean[c] + 0.5); };
        const std::uint32_t colour = mColours[std::size_t(nearest(rounded(0), rounded(1), rounded(2)))];
        const double d = distance(
            bin.mean, {double(channel(colour, 16)), double(channel(colour, 8)), double(channel(colour, 0))});
        sum += bin.weight * (mCount > 0 ? d : 3 * 255.0 * 255.0);
        weight += bin.weight;
    }
    return weight > 0.0 ? sum / weight : 0.0;
}

std::vector<std::uint8_t> GifPalette::indices(const Image &image)
{
    constexpr int exactEnough = 12; // squared: flat areas in a colour of the palette get no pattern
    constexpr int reach = 20;       // levels between two colours of a palette made of a photo, about
    std::vector<std::uint8_t> result(std::size_t(image.width) * std::size_t(image.height), transparent);
    const std::uint8_t *p = image.pixels.data();
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x, p += 4) {
            if (p[3] < 128)
                continue;
            int index = nearestCached(p[0], p[1], p[2]);
            const std::uint32_t plain = mColours[std::size_t(index)];
            const int dr = p[0] - channel(plain, 16), dg = p[1] - channel(plain, 8),
                      db = p[2] - channel(plain, 0);
            if (dr * dr + dg * dg + db * db > exactEnough) {
                const int shift = (threshold(x, y) * 2 - 63) * reach / 128;
                const auto moved = [&](int value) { return std::clamp(value + shift, 0, 255); };
                index = nearestCached(moved(p[0]), moved(p[1]), moved(p[2]));
            }
            result[std::size_t(y) * std::size_t(image.width) + std::size_t(x)] = std::uint8_t(index);
        }
    return result;
}

} // namespace ductus
