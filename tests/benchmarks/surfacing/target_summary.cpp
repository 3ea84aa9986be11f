#include "benchmarks/surfacing/target_summary.h"

#include "benchmarks/report/table.h"

#include <cmath>
#include <functional>
#include <optional>

namespace ductus {

namespace {

using Json = nlohmann::ordered_json;
using RowValue = std::function<std::optional<double>(const Json &row)>; // nothing: the row is not about it

std::optional<double> number(const Json &row, const char *key)
{
    const auto it = row.find(key);
    return it != row.end() && it->is_number() ? std::optional<double>(it->get<double>()) : std::nullopt;
}

RowValue plain(const char *key)
{
    return [key](const Json &row) { return number(row, key); };
}

// \a key where \a other is \a low to \a high.
RowValue where(const char *key, const char *other, double low, double high)
{
    return [=](const Json &row) -> std::optional<double> {
        const std::optional<double> tag = number(row, other);
        return tag && *tag >= low && *tag <= high ? number(row, key) : std::nullopt;
    };
}

std::optional<double> sumOf(const Json &row, const char *a, const char *b)
{
    const std::optional<double> x = number(row, a), y = number(row, b);
    return x && y ? std::optional<double>(*x + *y) : std::nullopt;
}

std::optional<double> regionsOff(const Json &row)
{
    const std::optional<double> found = number(row, "regions"), faces = number(row, "trueFaces");
    return found && faces && *faces > 0 ? std::optional<double>(100.0 * std::abs(*found / *faces - 1.0))
                                        : std::nullopt;
}

std::optional<double> missedCreases(const Json &row)
{
    const std::optional<double> recall = number(row, "creaseRecall");
    return recall ? std::optional<double>(100.0 * (1.0 - *recall)) : std::nullopt;
}

struct Target
{
    const char *name;
    const char *section;
    const char *table; // within the section; empty: the section is the table
    double most;       // in the unit of the name
    RowValue value;
    int decimals = 2;
};

std::vector<Target> allTargets()
{
    const auto worseMedian = [](const Json &row) -> std::optional<double> {
        const std::optional<double> a = number(row, "resultToTruthMedian"),
                                    b = number(row, "truthToResultMedian");
        return a && b ? std::optional<double>(std::max(*a, *b)) : std::nullopt;
    };
    const auto ofThousand = [](const char *key) { return where(key, "points", 1000, 1000); };
    const auto proxyCpu = [](const Json &row) -> std::optional<double> {
        const std::optional<double> points = number(row, "points");
        return points && *points == 1000 ? sumOf(row, "fitCpuSeconds", "contourCpuSeconds") : std::nullopt;
    };
    const auto labelsAndMesh = [](const Json &row) { return sumOf(row, "labelSeconds", "meshSeconds"); };
    return {
        {"median deviation from the truth, %", "truth", "", 0.3, worseMedian},
        {"largest deviation from the truth, %", "truth", "", 2.0, plain("resultToTruthMax")},
        {"sharp features without a crease, %", "truth", "", 0.0, missedCreases},
        {"regions off the true number, %", "truth", "", 20.0, regionsOff},
        {"phases 1-3, one run, s", "timing", "measured", 5.0, where("phase123Seconds", "runs", 1, 1)},
        {"phases 1-3, best of ten, s", "timing", "measured", 12.0, where("phase123Seconds", "runs", 2, 1000)},
        {"memory, MB", "timing", "measured", 1000.0, plain("peakMegabytes")},
        {"scribble to regions, s", "scribble", "measured", 0.3, plain("labelSeconds")},
        {"scribble to final mesh, s", "scribble", "measured", 1.5, labelsAndMesh},
        {"proxy at 1000 points, CPU s", "proxy", "measured", 11.47, proxyCpu},
        {"proxy at 1000 points, MB", "proxy", "measured", 259.0, ofThousand("peakMegabytes")},
        {"zero set off the truth, mean %", "proxy", "measured", 0.5, plain("truthToSetMean")},
        {"20,000 points to a closed proxy, s", "proxy", "clouds", 60.0,
         where("wallSeconds", "points", 20000, 20000)},
        {"their memory, MB", "proxy", "clouds", 1000.0, plain("peakMegabytes")},
    };
}

const Json *rowsOf(const Json &report, const Target &target)
{
    const auto section = report.find(target.section);
    if (section == report.end())
        return nullptr;
    const Json *table = &*section;
    if (*target.table) {
        const auto it = section->find(target.table);
        if (it == section->end())
            return nullptr;
        table = &*it;
    }
    const auto rows = table->find("rows");
    return rows != table->end() ? &*rows : nullptr;
}

std::string nameOf(const Json &row)
{
    for (const auto &[key, value] : row.items()) // the first column names the row
        return value.is_string() ? value.get<std::string>() : std::string();
    return {};
}

} // namespace

void printTargetSummary(const Json &report, std::ostream &out)
{
    std::optional<Table> table;
    for (const Target &target : allTargets()) {
        const Json *rows = rowsOf(report, target);
        if (!rows)
            continue;
        int measured = 0, met = 0;
        double worst = -1.0;
        std::string worstRow;
        for (const Json &row : *rows)
            if (const std::optional<double> value = target.value(row)) {
                ++measured;
                met += *value <= target.most;
                if (*value > worst) {
                    worst = *value;
                    worstRow = nameOf(row);
                }
            }
        if (measured == 0)
            continue;
        if (!table)
            table.emplace(out, "TARGETS of surfacing.md section 3 (at most), and the worst that was measured",
                          std::vector<Column>{{"target", "target", 36},
                                              {"most", "most", 7, 2},
                                              {"worst", "worst", 8, 2},
                                              {"worstRow", "of", 22},
                                              {"met", "met", 9},
                                              {"verdict", "", 22}});
        char share[32], verdict[64];
        std::snprintf(share, sizeof share, "%d of %d", met, measured);
        if (worst <= target.most)
            std::snprintf(verdict, sizeof verdict, "met");
        else if (target.most > 0.0)
            std::snprintf(verdict, sizeof verdict, "missed, %.1f times", worst / target.most);
        else
            std::snprintf(verdict, sizeof verdict, "missed by %.1f", worst);
        table->add({std::string(target.name), target.most, worst, worstRow, std::string(share),
                    std::string(verdict)});
    }
    if (table)
        table->note("seconds count only on a quiet machine: see 'others %' in the tables above");
}

} // namespace ductus
