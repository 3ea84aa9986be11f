#include "widgets/shell/job_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

struct Words
{
    Q_DECLARE_TR_FUNCTIONS(ductus::JobWords)
};

} // namespace

QString remainingWords(std::optional<int> seconds)
{
    if (!seconds)
        return {};
    if (*seconds < 5)
        return Words::tr("a few seconds");
    if (*seconds < 55)
        return Words::tr("about %1 s").arg((*seconds + 4) / 5 * 5);
    const int minutes = (*seconds + 29) / 60;
    if (minutes < 60)
        return Words::tr("about %1 min").arg(std::max(1, minutes));
    return Words::tr("about %1 h").arg(QLocale().toString(double(*seconds) / 3600.0, 'f', 1));
}

QString percentWords(double fraction)
{
    // Never 100 before it is done.
    const int percent = std::min(99, int(std::floor(fraction * 100.0)));
    return QString::number(percent) + QChar(0x202f) + QLatin1Char('%');
}

QString jobLine(const JobState &state)
{
    if (state.isCancelling)
        return Words::tr("Stopping: %1").arg(state.spec.title);
    if (state.isWaiting)
        return Words::tr("Waiting: %1").arg(state.spec.title);
    return state.text.isEmpty() ? state.spec.title : state.text;
}

} // namespace ductus
