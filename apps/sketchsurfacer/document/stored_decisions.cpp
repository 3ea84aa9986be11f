#include "sketchsurfacer/document/stored_decisions.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace ductus {

namespace {

using Json = nlohmann::json;

constexpr char tightnessMember[] = "tightness";
constexpr char symmetryMember[] = "symmetry";
constexpr char scribblesMember[] = "scribbles";
constexpr char tubeRadiusMember[] = "tubeRadius"; // share of the diagonal
constexpr std::size_t mostScribbles = 10'000;
constexpr std::size_t mostPoints = 1'000'000;

void putMember(UnknownMembers &members, const char *name, const Json &value)
{
    std::erase_if(members, [&](const auto &member) { return member.first == name; });
    members.emplace_back(name, value.dump());
}

std::optional<Json> member(const UnknownMembers &members, const char *name)
{
    for (const auto &[key, text] : members)
        if (key == name)
            return Json::parse(text, nullptr, false);
    return std::nullopt;
}

Error malformed(const char *name)
{
    return {ErrorCode::Malformed, "Opening the project",
            std::string("the member \"") + name + "\" is not as it should be",
            "Open an older copy of the file (its name ends in ~)", "settings"};
}

Json jsonOf(const std::vector<Scribble> &scribbles)
{
    Json list = Json::array();
    for (const Scribble &scribble : scribbles) {
        Json points = Json::array();
        for (const Vec3 &p : scribble.points)
            points.push_back({p.x(), p.y(), p.z()});
        Json entry = {{"kind", std::string(scribbleKindName(scribble.kind))}, {"points", std::move(points)}};
        if (scribble.degree > 0)
            entry["degree"] = scribble.degree;
        list.push_back(std::move(entry));
    }
    return list;
}

std::optional<Vec3> pointFrom(const Json &json)
{
    if (!json.is_array() || json.size() != 3)
        return std::nullopt;
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) {
        if (!json[std::size_t(axis)].is_number())
            return std::nullopt;
        p[axis] = json[std::size_t(axis)].get<double>();
    }
    return p.allFinite() ? std::optional(p) : std::nullopt;
}

std::optional<Scribble> scribbleFrom(const Json &json)
{
    if (!json.is_object() || !json.contains("kind") || !json["kind"].is_string() ||
        !json.contains("points") || !json["points"].is_array() || json["points"].size() > mostPoints)
        return std::nullopt;
    const auto kind = scribbleKindFromName(json["kind"].get<std::string>());
    if (!kind)
        return std::nullopt;
    Scribble scribble;
    scribble.kind = *kind;
    for (const Json &point : json["points"]) {
        const auto p = pointFrom(point);
        if (!p)
            return std::nullopt;
        scribble.points.push_back(*p);
    }
    if (json.contains("degree")) {
        if (!json["degree"].is_number_integer())
            return std::nullopt;
        const long long degree = json["degree"].get<long long>();
        if (degree < 0 || degree > 4)
            return std::nullopt;
        scribble.degree = int(degree);
    }
    return scribble;
}

} // namespace

void writeDecisions(const SketchContent &content, SurfacingSettings &settings)
{
    const SurfaceOptions &options = content.options;
    settings.epsilon = options.segmentation.epsilon;
    settings.simplicity = options.segmentation.simplicity;
    settings.smoothness = options.segmentation.smoothness;
    settings.runs = options.segmentation.runs;
    settings.seed = options.segmentation.seed;
    if (options.symmetry == SymmetryMode::Given) {
        if (!settings.symmetryPlane)
            settings.symmetryPlane.emplace();
        settings.symmetryPlane->normal = options.symmetryPlane.normal;
        settings.symmetryPlane->point = options.symmetryPlane.offset * options.symmetryPlane.normal;
    } else {
        settings.symmetryPlane.reset();
    }
    putMember(settings.unknown, symmetryMember, options.symmetry == SymmetryMode::Auto ? "auto" : "none");
    putMember(settings.unknown, tightnessMember, options.proxy.wrap.tightness);
    putMember(settings.unknown, scribblesMember, jsonOf(content.scribbles));
    putMember(settings.unknown, tubeRadiusMember, options.skeletal.radius);
}

Result<void> readDecisions(const SurfacingSettings &settings, SketchContent &content)
{
    SurfaceOptions &options = content.options;
    options.segmentation.epsilon = settings.epsilon;
    options.segmentation.simplicity = settings.simplicity;
    options.segmentation.smoothness = settings.smoothness;
    options.segmentation.runs = settings.runs;
    options.segmentation.seed = settings.seed;
    options.symmetry = SymmetryMode::None;
    if (settings.symmetryPlane) {
        const double length = settings.symmetryPlane->normal.norm();
        options.symmetry = SymmetryMode::Given;
        options.symmetryPlane.normal = settings.symmetryPlane->normal / length;
        options.symmetryPlane.offset = options.symmetryPlane.normal.dot(settings.symmetryPlane->point);
    } else if (const auto symmetry = member(settings.unknown, symmetryMember)) {
        if (*symmetry != "auto" && *symmetry != "none")
            return malformed(symmetryMember);
        if (*symmetry == "auto")
            options.symmetry = SymmetryMode::Auto;
    }
    if (const auto tightness = member(settings.unknown, tightnessMember)) {
        if (!tightness->is_number() || !std::isfinite(tightness->get<double>()))
            return malformed(tightnessMember);
        options.proxy.wrap.tightness = std::clamp(tightness->get<double>(), -1.0, 1.0);
    }
    if (const auto radius = member(settings.unknown, tubeRadiusMember)) {
        if (!radius->is_number() || !(radius->get<double>() > 0.0 && radius->get<double>() <= 0.5))
            return malformed(tubeRadiusMember);
        options.skeletal.radius = radius->get<double>();
    }
    if (const auto scribbles = member(settings.unknown, scribblesMember)) {
        if (!scribbles->is_array() || scribbles->size() > mostScribbles)
            return malformed(scribblesMember);
        for (const Json &entry : *scribbles) {
            const auto scribble = scribbleFrom(entry);
            if (!scribble)
                return malformed(scribblesMember);
            content.scribbles.push_back(*scribble);
        }
    }
    return {};
}

} // namespace ductus
