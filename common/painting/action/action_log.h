// The action log: what a painter did, a line of JSON each, to be looked at (thesis V.7.3) and played again:
//
//     {"time": "2026-05-01T10:00:00.250Z", "action": "addStack", "objects": {}, "parameters": {"name":
//     "tree"},
//      "made": [1, 2]}
//
// Besides the actions of action.h: "start" (an empty painting, or one from a file), "undo", "redo".
#pragma once

#include "base/job_control.h"
#include "painting/action/action.h"

#include <functional>
#include <string_view>

namespace ductus {

struct LogStart
{
    std::string source; // the file, empty for an empty painting
    std::string
        sha256; // of the painting as projectless JSON text (paintingFingerprint); empty for an empty one
};
struct LogUndo
{
};
struct LogRedo
{
};

struct LogEntry
{
    std::string time; // ISO 8601, UTC; may be empty
    std::variant<LogStart, LogUndo, LogRedo, PaintingAction> event;
    std::vector<std::int32_t> made = {}; // as in PerformedAction
};

/// SHA-256 of everything in \a painting; equal paintings have equal ones.
std::string paintingFingerprint(const Painting &painting);

/// The line without its end.
std::string logLine(const LogEntry &entry);

/// All lines of a log; empty ones are passed over. Errors name file and line.
Result<std::vector<LogEntry>> parsedLog(std::string_view text, const std::string &name);

/// Opens what a log starts from.
using OpenSource = std::function<Result<Painting>(const std::string &source)>;

/// Called after every entry, for playing step by step: false stops.
using AfterEntry = std::function<bool(std::size_t entry, const Painting &painting)>;

/// Plays \a log: the same log gives the same painting. Refused actions, starts that cannot be opened or are
/// other paintings, and ids that come out otherwise than in the log end it with an Error that names the line.
Result<Painting> replayed(const std::vector<LogEntry> &log, const std::string &name, const OpenSource &open,
                          const JobControl &control, const AfterEntry &after = {});

} // namespace ductus
