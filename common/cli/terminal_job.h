// A job run from a terminal: progress as one line on stderr, Ctrl-C, SIGTERM and a closed terminal cancel it.
#pragma once

#include "base/job_control.h"

#include <chrono>
#include <mutex>
#include <string>

namespace ductus {

class TerminalJob
{
public:
    /// Takes over SIGINT, SIGTERM and SIGHUP until destroyed, unless they were ignored: the first one
    /// cancels, a second one ends the program at once. SIGXFSZ is ignored meanwhile: a full quota is an error
    /// to tell, not a reason to die. \a quiet: no progress. On a terminal the line is rewritten in place,
    /// else each new step is a line.
    explicit TerminalJob(bool quiet);
    ~TerminalJob();
    TerminalJob(const TerminalJob &) = delete;
    TerminalJob &operator=(const TerminalJob &) = delete;

    JobControl control();

    /// Ends the progress line, so that what follows stands on a line of its own.
    void finishLine();

private:
    void show(double fraction, std::string_view text);

    bool mQuiet;
    bool mIsTerminal;
    bool mLineIsOpen = false;
    void (*mPrevious[3])(int) = {};
    void (*mPreviousFileSize)(int) = nullptr;
    double mLastFraction = 0.0;
    std::string mLastText;
    std::chrono::steady_clock::time_point mLastShown{};
    std::mutex mMutex; // progress may come from worker threads
};

} // namespace ductus
