// bench_tracking: how near tracked points stay, in tables beside the published figures (doodles.md section
// 2). Exit codes: 0 everything was measured, 1 a measurement failed, 2 wrong usage. A missed target is a
// finding, not a failure.
#include "benchmarks/report/table.h"
#include "benchmarks/tracking/joints_section.h"
#include "benchmarks/tracking/photo_section.h"
#include "benchmarks/tracking/synthetic_section.h"

#include <algorithm>
#include <fstream>
#include <iostream>

using namespace ductus;

namespace {

using Json = nlohmann::ordered_json;

struct Target
{
    const char *name, *section, *column, *input; // input: of the row; empty: the number of keyframes
    double least;                                // %
    int keyframes;
};

constexpr Target targets[] = {
    {"AJ strided, true depth and flow", "synthetic", "ajStrided", "true", 70.0, 0},
    {"AJ strided, found depth and flow", "synthetic", "ajStrided", "found", 45.0, 0},
    {"occlusion accuracy, true", "synthetic", "occlusionStrided", "true", 85.0, 0},
    {"occlusion accuracy, found", "synthetic", "occlusionStrided", "found", 85.0, 0},
    {"filmed things, one keyframe", "photos", "delta", "", 75.0, 1},
    {"filmed things, two keyframes", "photos", "delta", "", 85.0, 2},
    {"joints, one keyframe", "joints", "delta", "", 75.0, 1},
    {"joints, two keyframes", "joints", "delta", "", 85.0, 2},
};

// The mean of the rows the target is about.
std::optional<double> measured(const Target &target, const Json &report)
{
    if (!report.contains(target.section))
        return std::nullopt;
    double sum = 0.0;
    int rows = 0;
    for (const Json &row : report[target.section]["rows"]) {
        const bool isMeant = target.keyframes > 0
                                 ? row.value("keyframes", "") == std::to_string(target.keyframes)
                                 : row.value("input", "") == target.input;
        if (!isMeant || !row.contains(target.column) || !row[target.column].is_number())
            continue;
        sum += row[target.column].get<double>();
        ++rows;
    }
    return rows > 0 ? std::optional(sum / rows) : std::nullopt;
}

void printTargets(Json &report)
{
    Table table(std::cout, "TARGETS (doodles.md section 2; means over the rows)",
                {{"target", "target", 36, 0},
                 {"least", "least", 7, 1},
                 {"measured", "measured", 9, 1},
                 {"verdict", "", 18, 0}});
    for (const Target &target : targets) {
        const std::optional<double> value = measured(target, report);
        if (!value)
            continue;
        const double missing = target.least - *value;
        char verdict[32] = "met";
        if (missing > 0.0)
            std::snprintf(verdict, sizeof verdict, "missed by %.1f", missing);
        table.add({target.name, target.least, *value, std::string(verdict)});
    }
    report["targets"] = table.json();
}

} // namespace

int main(int argc, char **argv)
{
    bool isQuick = false;
    std::string only, json;
    for (int i = 1; i < argc; ++i) {
        const std::string name = argv[i];
        if (name == "--quick") {
            isQuick = true;
        } else if ((name == "--only" || name == "--json") && i + 1 < argc) {
            (name == "--only" ? only : json) = argv[++i];
        } else {
            std::cout << "usage: bench_tracking [--quick] [--only synthetic|photos|joints] [--json FILE]\n"
                         "  --quick   smaller synthetic clips, no filmed ones\n";
            return name == "--help" ? 0 : 2;
        }
    }
    if (!only.empty() && only != "synthetic" && only != "photos" && only != "joints") {
        std::cerr << "there is no section '" << only << "'\n";
        return 2;
    }
    Json report;
    int failures = 0;
    if (only.empty() || only == "synthetic")
        failures += runSyntheticSection(isQuick ? SyntheticSize{240, 136, 16, 48.0} : SyntheticSize{}, report,
                                        std::cout);
    if (only == "photos" || (only.empty() && !isQuick))
        failures += runPhotoSection(DUCTUS_SHARED_DATA, report, std::cout);
    if (only == "joints" || (only.empty() && !isQuick))
        failures += runJointsSection(DUCTUS_SHARED_DATA, report, std::cout);
    printTargets(report);
    if (!json.empty() && !(std::ofstream(json) << report.dump(2) << "\n")) {
        std::cerr << "cannot write " << json << "\n";
        return 1;
    }
    return failures > 0 ? 1 : 0;
}
