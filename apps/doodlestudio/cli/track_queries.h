// What `doodlestudio track` reads and writes (doodles.md section 3): queries with keyframes in pixels of the
// clip, and a track a query with one entry a frame.
#pragma once

#include "doodling/tracking/orientation.h"
#include "doodling/tracking/track_point.h"

#include <string>
#include <string_view>

namespace ductus {

struct TrackQuery
{
    std::string id;
    std::vector<CanvasKeyframe> keyframes; // working pixels
    std::vector<OrientationKeyframe> orientations;
};

/// \a name stands for the file in errors. Malformed with the place "tracks/3/keyframes/0/x" for what is
/// missing or no number.
Result<std::vector<TrackQuery>> parseQueries(std::string_view json, const std::string &name,
                                             const Shot &shot);

struct QueryAnswer
{
    std::string id;
    std::vector<TrackedPoint> points;
    std::vector<Eigen::Quaterniond> orientations; // worldFromCanvas, one a frame
};

/// As text, pixels of the clip.
std::string answersText(const std::vector<QueryAnswer> &answers, const Shot &shot);

} // namespace ductus
