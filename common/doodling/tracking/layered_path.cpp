#include "doodling/tracking/layered_path.h"

#include <algorithm>
#include <limits>

namespace ductus {

namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();

// How the cheapest way came to a cell or a hidden point: an index into the frame before, of its cells or its
// hidden points.
struct Origin
{
    int index = -1;
    bool isHidden = false;
};

struct HiddenPoint
{
    Vec3 place, motion;
    double cost = 0.0;
    int frames = 0; // hidden so far
    Origin origin;
};

struct Frame
{
    std::vector<double> costs; // one a cell
    std::vector<Origin> origins;
    std::vector<HiddenPoint> hidden;
};

double stepCost(const PathCell &from, const PathCell &to)
{
    const Vec3 expected = from.isKeyframed ? from.place : Vec3(from.place + from.motion);
    return (to.place - expected).squaredNorm();
}

void reachCells(const std::vector<PathCell> &cells, const std::vector<PathCell> &cellsBefore,
                const Frame &before, Frame &frame)
{
    frame.costs.assign(cells.size(), unreached);
    frame.origins.assign(cells.size(), {});
    for (std::size_t j = 0; j < cells.size(); ++j) {
        for (std::size_t i = 0; i < cellsBefore.size(); ++i) {
            const double cost = before.costs[i] + stepCost(cellsBefore[i], cells[j]);
            if (cost < frame.costs[j]) {
                frame.costs[j] = cost;
                frame.origins[j] = {int(i), false};
            }
        }
        for (std::size_t h = 0; h < before.hidden.size(); ++h) {
            const double cost =
                before.hidden[h].cost + (cells[j].place - before.hidden[h].place).squaredNorm();
            if (cost < frame.costs[j]) {
                frame.costs[j] = cost;
                frame.origins[j] = {int(h), true};
            }
        }
        frame.costs[j] += cells[j].cost;
    }
}

// A hidden point of a frame stands where the path, hidden in the frame, is expected in the next one.
void hide(const std::vector<PathCell> &cellsBefore, const Frame &before, const LayeredPathOptions &options,
          Frame &frame)
{
    std::vector<HiddenPoint> all;
    for (std::size_t i = 0; i < cellsBefore.size(); ++i)
        if (before.costs[i] < unreached) {
            const Vec3 motion = cellsBefore[i].isKeyframed ? Vec3(Vec3::Zero()) : cellsBefore[i].motion;
            all.push_back({cellsBefore[i].place + 2.0 * motion, motion, before.costs[i] + options.hiddenCost,
                           1, Origin{int(i), false}});
        }
    for (std::size_t h = 0; h < before.hidden.size(); ++h) {
        const HiddenPoint &point = before.hidden[h];
        if (point.frames < options.longestHidden)
            all.push_back({point.place + point.motion, point.motion, point.cost + options.hiddenCost,
                           point.frames + 1, Origin{int(h), true}});
    }
    const std::size_t kept = std::min(all.size(), std::size_t(std::max(0, options.hiddenPoints)));
    std::partial_sort(all.begin(), all.begin() + std::ptrdiff_t(kept), all.end(),
                      [](const HiddenPoint &a, const HiddenPoint &b) {
                          return a.cost != b.cost                         ? a.cost < b.cost
                                 : a.origin.isHidden != b.origin.isHidden ? b.origin.isHidden
                                                                          : a.origin.index < b.origin.index;
                      });
    all.resize(kept);
    frame.hidden = std::move(all);
}

LayeredPath tracedBack(const std::vector<std::vector<PathCell>> &layers, const std::vector<Frame> &frames)
{
    LayeredPath path;
    path.cells.assign(layers.size(), -1);
    path.places.resize(layers.size());
    const std::vector<double> &last = frames.back().costs;
    Origin at{int(std::min_element(last.begin(), last.end()) - last.begin()), false};
    path.cost = last[std::size_t(at.index)];
    for (std::size_t t = layers.size(); t-- > 0;) {
        if (at.isHidden) {
            const HiddenPoint &point = frames[t].hidden[std::size_t(at.index)];
            path.places[t] = point.place - point.motion;
            at = point.origin;
        } else {
            path.cells[t] = at.index;
            path.places[t] = layers[t][std::size_t(at.index)].place;
            at = frames[t].origins[std::size_t(at.index)];
        }
    }
    return path;
}

} // namespace

Result<LayeredPath> shortestPath(const std::vector<std::vector<PathCell>> &layers,
                                 const LayeredPathOptions &options, const JobControl &control)
{
    for (std::size_t t = 0; t < layers.size(); ++t)
        if (layers[t].empty())
            return Error{ErrorCode::InvalidArgument, "Following the canvas",
                         "frame " + std::to_string(t) + " has no cell to go to", "Set a keyframe there", ""};
    if (layers.empty())
        return Error{ErrorCode::InvalidArgument, "Following the canvas", "the clip has no frames", "", ""};
    std::vector<Frame> frames(layers.size());
    for (const PathCell &cell : layers[0]) {
        frames[0].costs.push_back(cell.cost);
        frames[0].origins.push_back({});
    }
    for (std::size_t t = 1; t < layers.size(); ++t) {
        if (control.isCancelled())
            return cancelledError("Following the canvas");
        reachCells(layers[t], layers[t - 1], frames[t - 1], frames[t]);
        const bool isKeyframe = layers[t].size() == 1 && layers[t][0].isKeyframed;
        if (!isKeyframe && t + 1 < layers.size()) // the last frame is reached in a cell
            hide(layers[t - 1], frames[t - 1], options, frames[t]);
    }
    return tracedBack(layers, frames);
}

} // namespace ductus
