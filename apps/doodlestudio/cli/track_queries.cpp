#include "doodlestudio/cli/track_queries.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace ductus {

namespace {

using Json = nlohmann::json;

class QueryReader
{
public:
    QueryReader(const std::string &name, const Shot &shot) : mName(name), mShot(shot) {}

    Result<std::vector<TrackQuery>> read(const Json &root)
    {
        if (!root.is_object() || !root.contains("tracks") || !root["tracks"].is_array())
            return wrong("tracks", "is missing or no list");
        std::vector<TrackQuery> queries;
        for (std::size_t i = 0; i < root["tracks"].size(); ++i) {
            Result<TrackQuery> query = readQuery(root["tracks"][i], "tracks/" + std::to_string(i));
            if (!query)
                return query.error();
            queries.push_back(std::move(*query));
        }
        return queries;
    }

private:
    Error wrong(const std::string &place, const std::string &problem) const
    {
        return {ErrorCode::Malformed, "Reading the queries", problem,
                "See `doodlestudio track` in the manual for the form of this file", mName + ": " + place};
    }

    Result<double> number(const Json &object, const char *key, const std::string &place) const
    {
        if (!object.contains(key) || !object[key].is_number() || !std::isfinite(object[key].get<double>()))
            return wrong(place + "/" + key, "is missing or no number");
        return object[key].get<double>();
    }

    Result<TrackQuery> readQuery(const Json &object, const std::string &place) const
    {
        if (!object.is_object() || !object.contains("id") || !object["id"].is_string())
            return wrong(place + "/id", "is missing or no text");
        if (!object.contains("keyframes") || !object["keyframes"].is_array() || object["keyframes"].empty())
            return wrong(place + "/keyframes", "is missing or empty");
        TrackQuery query;
        query.id = object["id"].get<std::string>();
        for (std::size_t k = 0; k < object["keyframes"].size(); ++k)
            if (Result<void> read =
                    readKeyframe(object["keyframes"][k], place + "/keyframes/" + std::to_string(k), query);
                !read)
                return read.error();
        const auto byFrame = [](const auto &a, const auto &b) { return a.frame < b.frame; };
        std::stable_sort(query.keyframes.begin(), query.keyframes.end(), byFrame);
        std::stable_sort(query.orientations.begin(), query.orientations.end(), byFrame);
        return query;
    }

    Result<void> readKeyframe(const Json &object, const std::string &place, TrackQuery &query) const
    {
        if (!object.is_object())
            return wrong(place, "is no object");
        const Result<double> frame = number(object, "frame", place), x = number(object, "x", place),
                             y = number(object, "y", place);
        for (const Result<double> *value : {&frame, &x, &y})
            if (!*value)
                return value->error();
        if (*frame != std::floor(*frame) || *frame < 0.0 || *frame >= mShot.frameCount())
            return wrong(place + "/frame",
                         "is no frame of the clip, which has " + std::to_string(mShot.frameCount()));
        CanvasKeyframe key{int(*frame), Vec2(*x, *y) * mShot.scale(), {}, false};
        if (object.contains("depth") && !object["depth"].is_null()) {
            const Result<double> depth = number(object, "depth", place);
            if (!depth || !(*depth > 0.0))
                return wrong(place + "/depth", "is no number above 0");
            key.depth = *depth;
        }
        query.keyframes.push_back(key);
        if (!object.contains("rotation") || object["rotation"].is_null())
            return {};
        const Json &rotation = object["rotation"];
        Eigen::Vector4d q = Eigen::Vector4d::Zero();
        if (rotation.is_array() && rotation.size() == 4)
            for (int i = 0; i < 4; ++i)
                q[i] = rotation[std::size_t(i)].is_number() ? rotation[std::size_t(i)].get<double>()
                                                            : std::nan("");
        if (!(q.norm() > 1e-9) || !q.allFinite())
            return wrong(place + "/rotation", "is no quaternion [x, y, z, w]");
        q.normalize();
        query.orientations.push_back({key.frame, Eigen::Quaterniond(q[3], q[0], q[1], q[2])});
        return {};
    }

    const std::string &mName;
    const Shot &mShot;
};

} // namespace

Result<std::vector<TrackQuery>> parseQueries(std::string_view json, const std::string &name, const Shot &shot)
{
    const Json root = Json::parse(json, nullptr, false);
    if (root.is_discarded())
        return Error{ErrorCode::Malformed, "Reading the queries", "it is no JSON",
                     "See `doodlestudio track` in the manual for the form of this file", name};
    return QueryReader(name, shot).read(root);
}

std::string answersText(const std::vector<QueryAnswer> &answers, const Shot &shot)
{
    Json tracks = Json::array();
    for (const QueryAnswer &answer : answers) {
        Json frames = Json::array();
        for (std::size_t t = 0; t < answer.points.size(); ++t) {
            const TrackedPoint &point = answer.points[t];
            const Eigen::Quaterniond &q = answer.orientations[t];
            frames.push_back({{"x", point.pixel.x() / shot.scale()},
                              {"y", point.pixel.y() / shot.scale()},
                              {"depth", point.depth},
                              {"visible", point.isVisible},
                              {"position", {point.position.x(), point.position.y(), point.position.z()}},
                              {"rotation", {q.x(), q.y(), q.z(), q.w()}}});
        }
        tracks.push_back({{"id", answer.id}, {"frames", std::move(frames)}});
    }
    return Json{{"tracks", std::move(tracks)}}.dump(1) + "\n";
}

} // namespace ductus
