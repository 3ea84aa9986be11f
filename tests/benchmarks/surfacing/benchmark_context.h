// What every section of bench_surfacing gets, and the list of sections.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

namespace ductus {

struct BenchmarkContext
{
    std::ostream &out;
    bool quick = false;              // one segmentation run, fewer cases
    std::vector<std::string> solids; // ids to measure; empty: all
    int runs = 0;                    // of the segmentation; 0: the pipeline's own number, 1 in quick
    std::uint64_t seed = 1;          // of the segmentation
    std::filesystem::path sharedData;
    std::filesystem::path pictures = {}; // a folder for contact sheets of the sweeps; empty: none

    bool wants(const std::string &solidId) const;
};

struct SectionReport
{
    nlohmann::ordered_json json;
    int failures = 0; // measurements that ended with an error instead of numbers
};

struct Section
{
    std::string name;
    std::string summary;
    bool inQuick = true;
    SectionReport (*run)(const BenchmarkContext &);

    /// By its whole name or by what stands before the hyphen: "sweeps" means all sweeps.
    bool isMeantBy(const std::string &text) const;
};

SectionReport runTruthSection(const BenchmarkContext &context);
SectionReport runTimingSection(const BenchmarkContext &context);
SectionReport runScribbleSection(const BenchmarkContext &context);
SectionReport runProxySection(const BenchmarkContext &context);
SectionReport runHabitSweeps(const BenchmarkContext &context);
SectionReport runParameterSweeps(const BenchmarkContext &context);
SectionReport runStartSweeps(const BenchmarkContext &context);

/// In the order they run.
const std::vector<Section> &allSections();

} // namespace ductus
