#include "sketchsurfacer/cli/scribble_file.h"

#include "formats/atomic_file.h"
#include "project/json/json_document.h"

#include <cmath>

namespace ductus {

namespace {

using Json = nlohmann::json;

constexpr char reading[] = "Reading the scribbles";
constexpr std::size_t largestFile = 64u << 20;
constexpr std::size_t mostScribbles = 10'000;
constexpr double largestCoordinate = 1e30;

// Remembers the first thing wrong; what follows is skipped.
class Decoder
{
public:
    explicit Decoder(std::string file) : mFile(std::move(file)) {}

    std::optional<Error> error;

    std::vector<Scribble> scribbles(const Json &json)
    {
        std::vector<Scribble> result;
        if (!json.is_object() || json.value("schema", Json()) != "scribbles")
            return fail("", "it is not an object with \"schema\": \"scribbles\""), result;
        const Json version = json.value("version", Json());
        if (!version.is_number_integer() || version.get<long long>() < 1)
            return fail("/version", "it is not a whole number from 1"), result;
        if (version.get<long long>() > 1)
            return fail("/version", "this version knows only 1", ErrorCode::NewerVersion), result;
        onlyMembers(json, "", {"schema", "version", "scribbles"});
        const Json list = json.value("scribbles", Json());
        if (!list.is_array() || list.size() > mostScribbles)
            return fail("/scribbles", "it is not a list of at most 10000"), result;
        for (std::size_t i = 0; i < list.size() && !error; ++i)
            result.push_back(scribble(list[i], "/scribbles/" + std::to_string(i)));
        return result;
    }

private:
    void fail(const std::string &place, std::string problem, ErrorCode code = ErrorCode::Malformed)
    {
        if (!error)
            error = Error{code, reading, std::move(problem), "The manual describes scribble files",
                          mFile + (place.empty() ? "" : "#" + place)};
    }

    // A misspelt word would be passed over in silence otherwise.
    void onlyMembers(const Json &object, const std::string &place,
                     std::initializer_list<std::string_view> known)
    {
        for (const auto &[name, value] : object.items())
            if (std::find(known.begin(), known.end(), name) == known.end())
                fail(place + "/" + name, "there is no member of this name");
    }

    Scribble scribble(const Json &json, const std::string &place)
    {
        Scribble result;
        if (!json.is_object())
            return fail(place, "it is not an object"), result;
        onlyMembers(json, place, {"kind", "points", "options"});
        const Json kind = json.value("kind", Json());
        const auto known = kind.is_string() ? scribbleKindFromName(kind.get<std::string>()) : std::nullopt;
        if (!known)
            return fail(place + "/kind",
                        "it is none of new-region, merge, seam, forbid-seam, split, lock and "
                        "set-degree"),
                   result;
        result.kind = *known;
        const Json points = json.value("points", Json());
        if (!points.is_array() || points.empty())
            return fail(place + "/points", "it is not a list of at least one point"), result;
        for (std::size_t i = 0; i < points.size() && !error; ++i)
            result.points.push_back(point(points[i], place + "/points/" + std::to_string(i)));
        const Json options = json.value("options", Json::object());
        if (!options.is_object())
            return fail(place + "/options", "it is not an object"), result;
        onlyMembers(options, place + "/options", {"degree"});
        const Json degree = options.value("degree", Json(0));
        if (!degree.is_number_integer() || degree.get<long long>() < (options.contains("degree") ? 1 : 0) ||
            degree.get<long long>() > 4)
            return fail(place + "/options/degree", "it is not a whole number from 1 to 4"), result;
        result.degree = int(degree.get<long long>());
        if (result.kind == ScribbleKind::SetDegree && result.degree == 0)
            fail(place + "/options/degree", "it is missing; set-degree needs it");
        return result;
    }

    Vec3 point(const Json &json, const std::string &place)
    {
        Vec3 p = Vec3::Zero();
        if (!json.is_array() || json.size() != 3)
            return fail(place, "it is not three numbers"), p;
        for (std::size_t k = 0; k < 3; ++k) {
            if (!json[k].is_number() || !(std::abs(json[k].get<double>()) <= largestCoordinate))
                return fail(place, "it is not three finite numbers"), p;
            p[int(k)] = json[k].get<double>();
        }
        return p;
    }

    std::string mFile;
};

} // namespace

Result<std::vector<Scribble>> parseScribbles(std::string text, const std::string &name)
{
    const Result<JsonDocument> document = parsedJson(std::move(text), name);
    if (!document)
        return document.error();
    Decoder decoder(name);
    std::vector<Scribble> scribbles = decoder.scribbles(document->value);
    if (decoder.error)
        return *decoder.error;
    return scribbles;
}

Result<std::vector<Scribble>> readScribbles(const std::filesystem::path &path)
{
    Result<std::string> text = readWholeFile(path, largestFile, reading);
    if (!text)
        return text.error();
    return parseScribbles(std::move(*text), path.string());
}

} // namespace ductus
