// Exit codes of every batch command (suite.md section 6), documented in each --help.
#pragma once

#include "base/error.h"

namespace ductus {

enum class ExitCode { Done = 0, Failed = 1, WrongUsage = 2, Cancelled = 3 };

inline ExitCode exitCodeFor(const Error &error)
{
    return error.isCancelled() ? ExitCode::Cancelled : ExitCode::Failed;
}

} // namespace ductus
