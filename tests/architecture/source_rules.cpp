#include "architecture/source_rules.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <regex>

namespace ductus {

namespace {

namespace fs = std::filesystem;

const std::string lastEngineLayer = "doodling";

// Position in layers(), or -1.
int layerIndex(const std::string &folder)
{
    const auto found = std::find(layers().begin(), layers().end(), folder);
    return found == layers().end() ? -1 : int(found - layers().begin());
}

struct SourceFile
{
    std::string path; // "common/base/error.h"
    std::string area; // "common" or "apps"
    std::string folder;
    bool isTest = false;

    int layer() const { return area == "common" ? layerIndex(folder) : int(layers().size()); }
    bool isEngine() const
    {
        return area == "common" && layer() >= 0 && layer() <= layerIndex(lastEngineLayer);
    }
};

struct Include
{
    std::string target; // as written between the marks
    bool quoted = false;

    std::string folder() const { return target.substr(0, std::min(target.find('/'), target.size())); }
};

std::optional<Include> includeOf(const std::string &line)
{
    static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
    std::smatch match;
    if (!std::regex_search(line, match, pattern))
        return std::nullopt;
    return Include{match[2].str(), match[1].str() == "\""};
}

bool isQtHeader(const std::string &target)
{
    static const std::regex pattern(R"(^(Q[A-Z]|Qt|q[a-z]+\.h$))");
    return std::regex_search(target, pattern);
}

bool isApp(const fs::path &root, const std::string &folder)
{
    return !folder.empty() && fs::is_directory(root / "apps" / folder);
}

// What is wrong with \a include in \a file; empty if nothing is.
std::string problemOf(const SourceFile &file, const Include &include, const fs::path &root)
{
    if (include.target.starts_with("CGAL/") && !(file.area == "common" && file.folder == "geometry"))
        return "CGAL is kept inside common/geometry: <" + include.target + ">";
    if (file.isEngine() && !file.isTest && isQtHeader(include.target))
        return "an engine folder includes Qt: <" + include.target + ">";
    if (include.target.find("../") != std::string::npos)
        return "includes are written from the root, without ../: \"" + include.target + "\"";

    const std::string folder = include.folder();
    const int layer = layerIndex(folder);
    if (layer >= 0 && include.target != folder) {
        if (layer > file.layer())
            return file.folder + " may not include " + folder + ", which stands above it: \"" +
                   include.target + "\"";
        return {};
    }
    if (!include.quoted || include.target.ends_with(".moc"))
        return {}; // a library, or what moc makes of the file itself
    if (isApp(root, folder)) {
        if (file.area == "apps" && file.folder == folder)
            return {};
        return file.folder + " may not include the app " + folder + ": \"" + include.target + "\"";
    }
    if (file.isTest && folder == "support")
        return {};
    return "begins with no known folder: \"" + include.target + "\"";
}

void checkFile(const SourceFile &file, const fs::path &root, SourceReport &report)
{
    ++report.files;
    std::ifstream stream(root / file.path);
    std::string line;
    int number = 0;
    while (std::getline(stream, line)) {
        ++number;
        const std::optional<Include> include = includeOf(line);
        if (!include)
            continue;
        ++report.includes;
        const std::string problem = problemOf(file, *include, root);
        if (!problem.empty())
            report.violations.push_back(file.path + ":" + std::to_string(number) + ": " + problem);
    }
    if (number > longestFile)
        report.violations.push_back(file.path + ":" + std::to_string(number) + ": longer than " +
                                    std::to_string(longestFile) + " lines");
}

} // namespace

const std::vector<std::string> &layers()
{
    static const std::vector<std::string> names{"base",    "numeric",  "geometry",  "imaging",  "strokes",
                                                "formats", "project",  "surfacing", "painting", "doodling",
                                                "render",  "document", "cli",       "widgets"};
    return names;
}

SourceReport checkSources(const fs::path &root)
{
    SourceReport report;
    for (const char *area : {"common", "apps"}) {
        if (!fs::is_directory(root / area))
            continue;
        for (const fs::directory_entry &entry : fs::recursive_directory_iterator(root / area)) {
            const std::string extension = entry.path().extension().string();
            if (!entry.is_regular_file() || (extension != ".h" && extension != ".cpp"))
                continue;
            const fs::path relative = fs::relative(entry.path(), root);
            SourceFile file;
            file.path = relative.generic_string();
            file.area = area;
            file.folder = std::next(relative.begin())->string();
            file.isTest = file.path.ends_with("_test.cpp");
            if (file.area == "common" && file.layer() < 0)
                report.violations.push_back(file.path + ":1: common/" + file.folder + " is no known layer");
            checkFile(file, root, report);
        }
    }
    std::sort(report.violations.begin(), report.violations.end());
    return report;
}

} // namespace ductus
