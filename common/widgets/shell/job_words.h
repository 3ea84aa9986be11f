// How jobs are told about in words: "Fitting 62 % - about 2 min".
#pragma once

#include "document/jobs/job_runner.h"

namespace ductus {

/// "about 2 min", "a few seconds"; empty if unknown.
QString remainingWords(std::optional<int> seconds);

/// "62 %"
QString percentWords(double fraction);

/// One line on a job: its stage, or its title as long as there is no stage.
QString jobLine(const JobState &state);

} // namespace ductus
