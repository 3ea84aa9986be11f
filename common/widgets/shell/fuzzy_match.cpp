#include "widgets/shell/fuzzy_match.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace ductus {

namespace {

constexpr int letterScore = 4;
constexpr int wordBeginBonus = 10;
constexpr int nameBeginBonus = 6;
constexpr int adjacentBonus = 8;
constexpr int noMatch = std::numeric_limits<int>::min() / 2;

bool beginsWord(const QString &name, qsizetype i)
{
    if (i == 0)
        return true;
    const QChar before = name[i - 1];
    return !before.isLetterOrNumber() || (before.isLower() && name[i].isUpper());
}

} // namespace

std::optional<FuzzyMatch> fuzzyMatch(const QString &typed, const QString &name)
{
    QString letters = typed.toCaseFolded();
    letters.removeIf([](QChar c) { return c.isSpace(); });
    if (letters.isEmpty())
        return FuzzyMatch{};
    const QString folded = name.toCaseFolded();
    // Case folding may change the length in a few languages; positions would then be wrong.
    const QString &text = folded.size() == name.size() ? folded : name;
    const std::size_t n = std::size_t(letters.size());
    const std::size_t m = std::size_t(text.size());
    if (n > m)
        return std::nullopt;

    // best[i][j]: score of the first i + 1 letters with the last of them at j.
    std::vector<std::vector<int>> best(n, std::vector<int>(m, noMatch));
    std::vector<std::vector<int>> from(n, std::vector<int>(m, -1));
    for (std::size_t i = 0; i < n; ++i) {
        int bestBefore = noMatch; // over all k < j - 1
        int bestBeforeAt = -1;
        for (std::size_t j = i; j < m; ++j) {
            if (i > 0 && j >= 2 && best[i - 1][j - 2] > bestBefore) {
                bestBefore = best[i - 1][j - 2];
                bestBeforeAt = int(j) - 2;
            }
            if (text[qsizetype(j)] != letters[qsizetype(i)])
                continue;
            int score = letterScore;
            if (beginsWord(name, qsizetype(j)))
                score += wordBeginBonus;
            if (j == 0)
                score += nameBeginBonus;
            if (i == 0) {
                best[i][j] = score - int(std::min<std::size_t>(j, 10)) / 2;
                continue;
            }
            const int adjacent =
                j > 0 && best[i - 1][j - 1] > noMatch ? best[i - 1][j - 1] + adjacentBonus : noMatch;
            if (adjacent == noMatch && bestBefore == noMatch)
                continue;
            best[i][j] = score + std::max(adjacent, bestBefore);
            from[i][j] = adjacent >= bestBefore ? int(j) - 1 : bestBeforeAt;
        }
    }
    const auto last = std::max_element(best[n - 1].begin(), best[n - 1].end());
    if (*last <= noMatch / 2)
        return std::nullopt;
    FuzzyMatch match;
    match.score = *last * 4 - int(m); // of two equal ones the shorter name
    int at = int(last - best[n - 1].begin());
    for (std::size_t i = n; i-- > 0;) {
        match.positions.prepend(at);
        at = from[i][std::size_t(at)];
    }
    return match;
}

} // namespace ductus
