// A job run from a terminal: progress as one line on stderr, Ctrl-C and SIGTERM cancel it.
#pragma once

#include "base/job_control.h"

#include <chrono>
#include <mutex>
#include <string>

namespace ductus {

class TerminalJob
{
public:
    /// Takes over SIGINT and SIGTERM until destroyed: the first one cancels, a second one ends the program at once.
    /// \a quiet: no progress. On a terminal the line is rewritten in place, else each new step is a line.
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
    std::string mLastText;
    std::chrono::steady_clock::time_point mLastShown{};
    std::mutex mMutex; // progress may come from worker threads
};

} // namespace ductus
