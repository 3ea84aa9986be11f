// Fuzzy matching of what somebody types against a name: the letters in order, better at the begin of words
// and in one piece.
#pragma once

#include <QList>
#include <QString>
#include <optional>

namespace ductus {

struct FuzzyMatch
{
    int score = 0;        // greater is better; comparable for the same typed text
    QList<int> positions; // of the matched letters in the name
};

/// Nothing if \a typed cannot be found in \a name; case and white space in \a typed do not matter. The best
/// of all possible matches.
std::optional<FuzzyMatch> fuzzyMatch(const QString &typed, const QString &name);

} // namespace ductus
