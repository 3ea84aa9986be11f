#include "cli/terminal_job.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <unistd.h>

namespace ductus {

namespace {

// Signal handlers reach nothing but globals; one terminal job runs at a time.
std::atomic<bool> cancelRequested = false;
static_assert(std::atomic<bool>::is_always_lock_free);

constexpr int cancelSignals[] = {SIGINT, SIGTERM, SIGHUP};

extern "C" void requestCancel(int signal)
{
    if (cancelRequested.exchange(true)) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
}

} // namespace

TerminalJob::TerminalJob(bool quiet) : mQuiet(quiet), mIsTerminal(isatty(STDERR_FILENO) != 0)
{
    cancelRequested = false;
    for (std::size_t i = 0; i < std::size(cancelSignals); ++i) {
        mPrevious[i] = std::signal(cancelSignals[i], requestCancel);
        // nohup, or a shell that runs it in the background, had it ignored: so it stays.
        if (mPrevious[i] == SIG_IGN)
            std::signal(cancelSignals[i], SIG_IGN);
    }
    mPreviousFileSize = std::signal(SIGXFSZ, SIG_IGN);
}

TerminalJob::~TerminalJob()
{
    finishLine();
    for (std::size_t i = 0; i < std::size(cancelSignals); ++i)
        std::signal(cancelSignals[i], mPrevious[i]);
    std::signal(SIGXFSZ, mPreviousFileSize);
}

JobControl TerminalJob::control()
{
    return JobControl(&cancelRequested,
                      [this](double fraction, std::string_view text) { show(fraction, text); });
}

void TerminalJob::finishLine()
{
    const std::lock_guard lock(mMutex);
    if (mLineIsOpen)
        std::fputc('\n', stderr);
    mLineIsOpen = false;
}

void TerminalJob::show(double fraction, std::string_view text)
{
    if (mQuiet)
        return;
    const std::lock_guard lock(mMutex);
    // A stage that reports a step twice, or parallel runs that overtake each other, must not let it run
    // backwards.
    fraction = mLastFraction = std::max(mLastFraction, fraction);
    const auto now = std::chrono::steady_clock::now();
    const bool isNewText = text != mLastText;
    if (mIsTerminal) {
        if (!isNewText && now - mLastShown < std::chrono::milliseconds(80))
            return;
        std::fprintf(stderr, "\r\033[K%3.0f %%  %.*s", 100.0 * fraction, int(text.size()), text.data());
        std::fflush(stderr);
        mLineIsOpen = true;
    } else if (isNewText) {
        std::fprintf(stderr, "%3.0f %%  %.*s\n", 100.0 * fraction, int(text.size()), text.data());
    }
    mLastText = text;
    mLastShown = now;
}

} // namespace ductus
