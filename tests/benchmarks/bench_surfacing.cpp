// bench_surfacing: how good and how fast surfacing is, in tables beside the published figures (surfacing.md
// section 3). Exit codes: 0 everything was measured, 1 a measurement failed, 2 wrong usage. A missed target
// is a finding, not a failure.
#include "benchmarks/surfacing/benchmark_context.h"
#include "benchmarks/surfacing/target_summary.h"
#include "formats/atomic_file.h"
#include "support/solids.h"

#include <algorithm>
#include <charconv>
#include <iostream>
#include <optional>
#include <span>
#include <sstream>

using namespace ductus;

namespace {

struct Arguments
{
    bool quick = false;
    bool help = false;
    std::string only, json, pictures;
    std::vector<std::string> solids;
    int runs = 0;
    int seed = 1;
};

void printUsage(std::ostream &out)
{
    out << "usage: bench_surfacing [--quick] [--only SECTION] [--solids A,B] [--runs N] [--seed N] [--json "
           "FILE] [--pictures DIR]\n"
           "  --quick   one segmentation run and fewer cases; leaves out the sections marked *\n"
           "  --solids  only these, where a section goes through the solids\n"
           "  --runs    of the segmentation (the best counts)\n"
           "  --pictures  a contact sheet of each of the sweeps\n"
           "sections:\n";
    for (const Section &section : allSections())
        out << "  " << section.name << (section.inQuick ? "" : "*")
            << std::string(20 - section.name.size() - !section.inQuick, ' ') << section.summary << "\n";
}

std::optional<int> numberIn(const std::string &text)
{
    int number = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure != std::errc() || end != text.data() + text.size() || number < 1)
        return std::nullopt;
    return number;
}

// The arguments, or what is wrong with them.
std::optional<std::string> parse(int argc, char **argv, Arguments &arguments)
{
    for (int i = 1; i < argc; ++i) {
        const std::string name = argv[i];
        if (name == "--quick" || name == "--help") {
            (name == "--quick" ? arguments.quick : arguments.help) = true;
            continue;
        }
        if (i + 1 == argc)
            return "'" + name + "' is unknown, or lacks its value";
        const std::string value = argv[++i];
        if (name == "--only") {
            const auto &sections = allSections();
            if (std::none_of(sections.begin(), sections.end(),
                             [&](const Section &s) { return s.isMeantBy(value); }))
                return "there is no section '" + value + "'";
            arguments.only = value;
        } else if (name == "--json" || name == "--pictures") {
            (name == "--json" ? arguments.json : arguments.pictures) = value;
        } else if (name == "--solids") {
            std::istringstream list(value);
            for (std::string id; std::getline(list, id, ',');) {
                const auto &known = allSolids();
                if (std::none_of(known.begin(), known.end(), [&](const SolidEntry &s) { return s.id == id; }))
                    return "there is no solid '" + id + "'";
                arguments.solids.push_back(id);
            }
        } else if (name == "--runs" || name == "--seed") {
            const std::optional<int> number = numberIn(value);
            if (!number)
                return name + " needs a number above 0";
            (name == "--runs" ? arguments.runs : arguments.seed) = *number;
        } else {
            return "'" + name + "' is unknown";
        }
    }
    return std::nullopt;
}

// True also for no file at all and for one in the folder the program was started in.
bool folderExists(const std::filesystem::path &file)
{
    std::error_code failure;
    return !file.has_parent_path() || std::filesystem::is_directory(file.parent_path(), failure);
}

} // namespace

int main(int argc, char **argv)
{
    Arguments arguments;
    if (const auto complaint = parse(argc, argv, arguments)) {
        std::cerr << "bench_surfacing: " << *complaint << "\n";
        printUsage(std::cerr);
        return 2;
    }
    if (arguments.help) {
        printUsage(std::cout);
        return 0;
    }
    // Told before the measuring, which may take an hour.
    if (!folderExists(arguments.json)) {
        std::cerr << "bench_surfacing: " << arguments.json
                  << ": Writing the report failed: there is no such folder\n";
        return 1;
    }
    std::error_code failure;
    if (!arguments.pictures.empty() && !std::filesystem::is_directory(arguments.pictures, failure)) {
        std::cerr << "bench_surfacing: " << arguments.pictures
                  << ": Writing the pictures failed: there is no such folder\n";
        return 1;
    }
    const int runs = arguments.runs > 0 ? arguments.runs : arguments.quick ? 1 : 0;
    const BenchmarkContext context{
        std::cout,          arguments.quick,   arguments.solids, runs, std::uint64_t(arguments.seed),
        DUCTUS_SHARED_DATA, arguments.pictures};
    nlohmann::ordered_json report;
    int failures = 0;
    for (const Section &section : allSections()) {
        const bool wanted =
            arguments.only.empty() ? section.inQuick || !arguments.quick : section.isMeantBy(arguments.only);
        if (!wanted)
            continue;
        const SectionReport part = section.run(context);
        report[section.name] = part.json;
        failures += part.failures;
    }
    printTargetSummary(report, std::cout);
    if (!arguments.json.empty()) {
        const std::string text = report.dump(2) + "\n";
        const Result<void> written =
            writeFileAtomically(arguments.json, std::as_bytes(std::span(text)), "Writing the report");
        if (!written) {
            std::cerr << "bench_surfacing: " << written.error().message() << "\n";
            return 1;
        }
    }
    if (failures > 0)
        std::cerr << "bench_surfacing: " << failures << " measurements failed\n";
    return failures > 0 ? 1 : 0;
}
