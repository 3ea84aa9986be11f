#include "doodling/reconstruction/rough_match.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace ductus {

namespace {

using Eigen::Vector2f;
using Level = WindowPyramid::Level;

constexpr int seedStep = 4;        // pixels of the finest level
constexpr float homeMiss = 2.0f;   // pixels of the finest level: there and back
constexpr float likeMotion = 3.0f; // pixels of the finest level: neighbours that move together
constexpr int fewestAlike = 3;     // of eight neighbours
constexpr int costOutside = 400;   // of a window that left the picture

const std::uint8_t *windowAt(const Level &level, int x, int y)
{
    return level.placeAt(std::clamp(x, 0, level.width - 1), std::clamp(y, 0, level.height - 1));
}

// Sum of the differences of eight numbers each.
#ifdef __SSE2__
int differenceOfRow(const std::uint8_t *a, const std::uint8_t *b)
{
    constexpr std::ptrdiff_t step = WindowPyramid::placeStep * WindowPyramid::placeNumbers;
    __m128i sum = _mm_setzero_si128();
    for (std::ptrdiff_t place : {-step, std::ptrdiff_t(0), step})
        sum = _mm_add_epi64(sum, _mm_sad_epu8(_mm_loadl_epi64(reinterpret_cast<const __m128i *>(a + place)),
                                              _mm_loadl_epi64(reinterpret_cast<const __m128i *>(b + place))));
    return _mm_cvtsi128_si32(sum);
}
#else
int differenceOfRow(const std::uint8_t *a, const std::uint8_t *b)
{
    constexpr std::ptrdiff_t step = WindowPyramid::placeStep * WindowPyramid::placeNumbers;
    int sum = 0;
    for (std::ptrdiff_t place : {-step, std::ptrdiff_t(0), step})
        for (std::ptrdiff_t i = place; i < place + WindowPyramid::placeNumbers; ++i)
            sum += std::abs(int(a[i]) - int(b[i]));
    return sum;
}
#endif

// Between the windows around two places of levels whose rows are so many bytes apart.
int differenceOf(const std::uint8_t *a, std::ptrdiff_t rowA, const std::uint8_t *b, std::ptrdiff_t rowB)
{
    return differenceOfRow(a - rowA, b - rowB) + differenceOfRow(a, b) + differenceOfRow(a + rowA, b + rowB);
}

std::ptrdiff_t windowRowBytes(const Level &level)
{
    return level.rowLength() * WindowPyramid::placeNumbers * WindowPyramid::placeStep;
}

// The same numbers on every machine, -1..1.
class Dice
{
public:
    float next()
    {
        mState = mState * 1664525u + 1013904223u;
        return float(mState >> 8) * (2.0f / 16777216.0f) - 1.0f;
    }

private:
    std::uint32_t mState = 12345;
};

class SeedSearch
{
public:
    SeedSearch(const WindowPyramid &from, const WindowPyramid &to)
        : mFrom(from), mTo(to), mColumns(std::max(1, from.levels[0].width / seedStep)),
          mRows(std::max(1, from.levels[0].height / seedStep)),
          mMotions(std::size_t(mColumns * mRows), Vector2f::Zero()), mCosts(mMotions.size(), 0)
    {
    }

    int columns() const { return mColumns; }
    int rows() const { return mRows; }

    // Pixels of the finest level.
    const std::vector<Vector2f> &run()
    {
        const int levels = int(mFrom.levels.size());
        for (int level = levels - 1; level >= 0; --level) {
            const Level &from = mFrom.levels[std::size_t(level)];
            const bool isCoarsest = level == levels - 1;
            const float reach = isCoarsest ? 0.35f * float(std::max(from.width, from.height)) : 4.0f;
            const int sweeps = isCoarsest ? 8 : level == 0 ? 2 : 4;
            for (int i = 0; i < mColumns * mRows; ++i) {
                Vector2f &motion = mMotions[std::size_t(i)];
                motion *= isCoarsest ? 1.0f : 2.0f;
                mCosts[std::size_t(i)] = costOf(level, i, motion);
            }
            for (int sweep = 0; sweep < sweeps; ++sweep)
                sweepOnce(level, sweep % 2 == 0, reach);
        }
        return mMotions;
    }

private:
    int costOf(int level, int seed, const Vector2f &motion) const
    {
        const Level &from = mFrom.levels[std::size_t(level)], &to = mTo.levels[std::size_t(level)];
        const float scale = float(seedStep) / float(1 << level);
        const float x = (float(seed % mColumns) + 0.5f) * scale, y = (float(seed / mColumns) + 0.5f) * scale;
        const float there = x + motion.x(), below = y + motion.y();
        const bool isOutside =
            there < 0.0f || below < 0.0f || there >= float(to.width) || below >= float(to.height);
        return (isOutside ? costOutside : 0) +
               differenceOf(windowAt(from, int(x), int(y)), windowRowBytes(from),
                            windowAt(to, int(std::floor(there)), int(std::floor(below))), windowRowBytes(to));
    }

    void offer(int level, int seed, const Vector2f &motion)
    {
        const int cost = costOf(level, seed, motion);
        if (cost < mCosts[std::size_t(seed)]) {
            mCosts[std::size_t(seed)] = cost;
            mMotions[std::size_t(seed)] = motion;
        }
    }

    void sweepOnce(int level, bool isForward, float reach)
    {
        const int count = mColumns * mRows, back = isForward ? -1 : 1;
        for (int k = 0; k < count; ++k) {
            const int seed = isForward ? k : count - 1 - k;
            const int column = seed % mColumns + back, row = seed / mColumns + back;
            if (column >= 0 && column < mColumns)
                offer(level, seed, mMotions[std::size_t(seed + back)]);
            if (row >= 0 && row < mRows)
                offer(level, seed, mMotions[std::size_t(seed + back * mColumns)]);
            for (float radius = reach; radius >= 1.0f; radius *= 0.5f) {
                const float dx = mDice.next(), dy = mDice.next();
                offer(level, seed, mMotions[std::size_t(seed)] + radius * Vector2f(dx, dy));
            }
        }
    }

    const WindowPyramid &mFrom, &mTo;
    int mColumns, mRows;
    std::vector<Vector2f> mMotions;
    std::vector<int> mCosts;
    Dice mDice;
};

bool comesHome(int seed, int columns, int rows, const std::vector<Vector2f> &there,
               const std::vector<Vector2f> &back)
{
    const Vector2f &motion = there[std::size_t(seed)];
    const int x = int(std::floor((float(seed % columns) + 0.5f) + motion.x() / seedStep));
    const int y = int(std::floor((float(seed / columns) + 0.5f) + motion.y() / seedStep));
    for (int row = std::max(0, y - 1); row <= std::min(rows - 1, y + 1); ++row)
        for (int column = std::max(0, x - 1); column <= std::min(columns - 1, x + 1); ++column)
            if ((motion + back[std::size_t(row * columns + column)]).norm() < homeMiss)
                return true;
    return false;
}

// A find that no neighbour shares is chance.
bool isShared(int seed, int columns, int rows, const std::vector<Vector2f> &motions,
              const std::vector<char> &isHome)
{
    int alike = 0;
    const int x = seed % columns, y = seed / columns;
    for (int row = std::max(0, y - 1); row <= std::min(rows - 1, y + 1); ++row)
        for (int column = std::max(0, x - 1); column <= std::min(columns - 1, x + 1); ++column) {
            const std::size_t other = std::size_t(row * columns + column);
            if (int(other) != seed && isHome[other] &&
                (motions[other] - motions[std::size_t(seed)]).norm() < likeMotion)
                ++alike;
        }
    return alike >= fewestAlike;
}

RoughMotion filled(int columns, int rows, const std::vector<Vector2f> &there,
                   const std::vector<Vector2f> &back)
{
    const int count = columns * rows;
    std::vector<char> isHome(std::size_t(count), 0);
    for (int i = 0; i < count; ++i)
        isHome[std::size_t(i)] = comesHome(i, columns, rows, there, back);
    RoughMotion result;
    result.width = columns;
    result.height = rows;
    result.cellSize = 2.0 * seedStep;
    result.motions.assign(std::size_t(count), Vector2f::Zero());
    std::vector<char> isKnown(std::size_t(count), 0);
    std::vector<int> queue;
    for (int i = 0; i < count; ++i)
        if (isHome[std::size_t(i)] && isShared(i, columns, rows, there, isHome)) {
            result.motions[std::size_t(i)] = 2.0f * there[std::size_t(i)];
            isKnown[std::size_t(i)] = 1;
            queue.push_back(i);
        }
    result.surenessShare = double(queue.size()) / count;
    for (std::size_t head = 0; head < queue.size(); ++head) {
        const int i = queue[head], x = i % columns, y = i / columns;
        const auto spread = [&](bool isInside, int next) {
            if (!isInside || isKnown[std::size_t(next)])
                return;
            isKnown[std::size_t(next)] = 1;
            result.motions[std::size_t(next)] = result.motions[std::size_t(i)];
            queue.push_back(next);
        };
        spread(x + 1 < columns, i + 1);
        spread(x > 0, i - 1);
        spread(y + 1 < rows, i + columns);
        spread(y > 0, i - columns);
    }
    return result;
}

} // namespace

RoughMotionPair roughMotion(const WindowPyramid &from, const WindowPyramid &to)
{
    SeedSearch ahead(from, to), behind(to, from);
    const std::vector<Vector2f> &there = ahead.run(), &back = behind.run();
    return {filled(ahead.columns(), ahead.rows(), there, back),
            filled(ahead.columns(), ahead.rows(), back, there)};
}

} // namespace ductus
