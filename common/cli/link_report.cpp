#include "cli/link_report.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace ductus {

namespace {

const char *stateOf(const LinkLine &line)
{
    return line.isChanged ? "changed" : line.problem ? "unknown" : "unchanged";
}

nlohmann::ordered_json reportOf(const std::vector<LinkLine> &links, bool isUpdated)
{
    nlohmann::ordered_json report = {{"schema", "link-report"},
                                     {"version", 1},
                                     {"updated", isUpdated},
                                     {"links", nlohmann::json::array()}};
    for (const LinkLine &line : links) {
        nlohmann::ordered_json one = {{"name", line.link.name},
                                      {"file", line.link.file},
                                      {"document", line.link.document.text()},
                                      {line.countName, line.count},
                                      {"state", stateOf(line)}};
        if (line.problem)
            one["problem"] = line.problem->message();
        report["links"].push_back(std::move(one));
    }
    return report;
}

std::string linesOf(const std::vector<LinkLine> &links, bool isUpdated)
{
    std::string lines;
    for (const LinkLine &line : links)
        lines += "\"" + line.link.name + "\"" + (line.link.file.empty() ? "" : " of " + line.link.file) +
                 ": " + stateOf(line) + (line.isChanged && isUpdated ? ", updated" : "") +
                 (line.problem ? " (" + line.problem->problem + ")" : "") + "\n";
    return lines;
}

} // namespace

UpdateOptions::UpdateOptions()
    : output({QStringLiteral("o"), QStringLiteral("output")},
             QStringLiteral("The project to write; without it P.ductus itself."),
             QStringLiteral("OUT.ductus")),
      check(QStringLiteral("check"), QStringLiteral("Only says what has changed and writes nothing.")),
      json(QStringLiteral("json"), QStringLiteral("Says it as JSON."))
{
}

void UpdateOptions::addTo(BatchParser &parser) const
{
    for (const QCommandLineOption &option : {output, check, json})
        parser.addOption(option);
}

void printLinks(const std::vector<LinkLine> &links, bool isUpdated, bool asJson, const std::string &none)
{
    const std::string text = asJson          ? reportOf(links, isUpdated).dump(2) + "\n"
                             : links.empty() ? none + "\n"
                                             : linesOf(links, isUpdated);
    std::fputs(text.c_str(), stdout);
}

} // namespace ductus
