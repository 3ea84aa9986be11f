#include "sketchsurfacer/cli/print_report.h"

#include <cmath>
#include <cstdio>

namespace ductus {

namespace {

using Json = nlohmann::ordered_json;

double rounded(double value)
{
    if (value == 0.0 || !std::isfinite(value))
        return 0.0;
    const double scale = std::pow(10.0, 4 - std::floor(std::log10(std::abs(value))));
    return std::round(value * scale) / scale;
}

Json placeJson(const Vec3 &p)
{
    return {rounded(p.x()), rounded(p.y()), rounded(p.z())};
}

Json sampleJson(const std::optional<ThicknessSample> &sample, double millimetres)
{
    if (!sample)
        return nullptr;
    return {{"millimetres", rounded(sample->length * millimetres)}, {"place", placeJson(sample->place)}};
}

Json crossingJson(const std::vector<TrianglePair> &pairs, const std::optional<Vec3> &place)
{
    return {{"trianglePairs", pairs.size()}, {"place", place ? placeJson(*place) : Json(nullptr)}};
}

std::string lengthLine(const char *what, const std::optional<ThicknessSample> &sample, double millimetres)
{
    char text[160];
    if (!sample)
        return "";
    std::snprintf(text, sizeof text, "  %s: %.3g mm at (%.4g, %.4g, %.4g)\n", what,
                  sample->length * millimetres, sample->place.x(), sample->place.y(), sample->place.z());
    return text;
}

} // namespace

nlohmann::ordered_json printReport(const PrintCheck &check, double metresPerUnit)
{
    const double millimetres = 1000.0 * metresPerUnit;
    const Vec3 size = check.box.isEmpty() ? Vec3::Zero() : Vec3(check.box.max - check.box.min);
    Json report;
    report["sizeMillimetres"] = placeJson(millimetres * size);
    report["watertight"] = check.isWatertight;
    report["pieces"] = check.shells;
    report["volumeCubicMillimetres"] =
        check.isWatertight ? Json(rounded(check.volume * std::pow(millimetres, 3))) : Json(nullptr);
    report["thinnestWall"] = sampleJson(check.thinnestWall, millimetres);
    report["narrowestGap"] = sampleJson(check.narrowestGap, millimetres);
    report["selfCrossings"] = crossingJson(check.crossings, check.crossing);
    report["overlaps"] = crossingJson(check.overlaps, check.overlap);
    return report;
}

std::string printLines(const PrintCheck &check, double metresPerUnit)
{
    const double millimetres = 1000.0 * metresPerUnit;
    const Vec3 size =
        millimetres * (check.box.isEmpty() ? Vec3::Zero() : Vec3(check.box.max - check.box.min));
    char text[200];
    std::snprintf(text, sizeof text, "  size: %.4g x %.4g x %.4g mm, %s, %d piece%s\n", size.x(), size.y(),
                  size.z(), check.isWatertight ? "watertight" : "not watertight", check.shells,
                  check.shells == 1 ? "" : "s");
    std::string lines = text;
    lines += lengthLine("thinnest wall", check.thinnestWall, millimetres);
    lines += lengthLine("narrowest gap", check.narrowestGap, millimetres);
    if (!check.crossings.empty())
        lines += "  runs through itself: " + std::to_string(check.crossings.size()) + " pairs of triangles\n";
    if (!check.overlaps.empty())
        lines += "  pieces overlap: " + std::to_string(check.overlaps.size()) + " pairs of triangles\n";
    return lines;
}

} // namespace ductus
