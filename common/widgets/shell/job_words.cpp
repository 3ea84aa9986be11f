#include "widgets/shell/job_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

QString text(const char *source, int number = -1)
{
    return QCoreApplication::translate("ductus::JobWords", source, nullptr, number);
}

} // namespace

QString remainingWords(std::optional<int> seconds)
{
    if (!seconds)
        return {};
    if (*seconds < 5)
        return text("a few seconds");
    if (*seconds < 55)
        return text("about %1 s").arg((*seconds + 4) / 5 * 5);
    const int minutes = (*seconds + 29) / 60;
    if (minutes < 60)
        return text("about %1 min").arg(std::max(1, minutes));
    return text("about %1 h").arg(QLocale().toString(double(*seconds) / 3600.0, 'f', 1));
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
        return text("Stopping: %1").arg(state.spec.title);
    if (state.isWaiting)
        return text("Waiting: %1").arg(state.spec.title);
    return state.text.isEmpty() ? state.spec.title : state.text;
}

} // namespace ductus
