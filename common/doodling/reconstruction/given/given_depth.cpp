#include "doodling/reconstruction/given/given_depth.h"

#include "doodling/reconstruction/depth/edge_aware_smoothing.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr char attempted[] = "Taking the depth maps";
constexpr int sampledFrames = 16; // tell the factor

double medianOf(std::vector<double> &values)
{
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

class DepthTaker
{
public:
    DepthTaker(const Shot &shot, const std::vector<std::filesystem::path> &files) : mShot(shot), mFiles(files)
    {
    }

    Result<std::vector<float>> disparities(int frame) const
    {
        const std::filesystem::path &file = mFiles[std::size_t(frame)];
        const Result<GivenDepth> depth = readDepthFile(file);
        if (!depth)
            return depth.error();
        const double shape = double(depth->width) / depth->height,
                     wanted = double(mShot.width) / mShot.height;
        const auto wrong = [&](const std::string &problem, const std::string &remedy) {
            return Error{ErrorCode::Malformed, attempted, problem, remedy, file.string()};
        };
        if (std::abs(shape / wanted - 1.0) > 0.03)
            return wrong("it has another shape than the clip",
                         "Give depth maps of the whole picture, of any size");
        if (std::none_of(depth->depths.begin(), depth->depths.end(), [](float d) { return d > 0.0f; }))
            return wrong("there is no depth in it", "Write it again, or give the one of a frame beside it");
        return gridDisparities(*depth, mShot.depths[std::size_t(frame)], mShot.width, mShot.height);
    }

    // What the files' disparities are multiplied with to be the shot's.
    Result<double> factor(const JobControl &control) const
    {
        std::vector<double> ratios;
        const int step = std::max(1, mShot.frameCount() / sampledFrames);
        for (int t = 0; t < mShot.frameCount(); t += step) {
            if (control.isCancelled())
                return cancelledError(attempted);
            const Result<std::vector<float>> given = disparities(t);
            if (!given)
                return given.error();
            const DepthMap &own = mShot.depths[std::size_t(t)];
            for (std::size_t i = 0; i < given->size(); ++i)
                if (own.objects.empty() || own.objects[i] == 0)
                    ratios.push_back(own.cellDisparity(i) / double((*given)[i]));
            mShot.forgetPages(t, t);
        }
        return ratios.empty() ? 1.0 : medianOf(ratios);
    }

private:
    const Shot &mShot;
    const std::vector<std::filesystem::path> &mFiles;
};

} // namespace

std::vector<float> gridDisparities(const GivenDepth &depth, const DepthMap &grid, int pictureWidth,
                                   int pictureHeight)
{
    std::vector<float> values(grid.disparities.size(), 0.0f), weights(values.size(), 0.0f);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double x = (double(i % std::size_t(grid.width)) + 0.5) * grid.cellSize / pictureWidth;
        const double y = (double(i / std::size_t(grid.width)) + 0.5) * grid.cellSize / pictureHeight;
        const int column = std::clamp(int(x * depth.width), 0, depth.width - 1);
        const int row = std::clamp(int(y * depth.height), 0, depth.height - 1);
        // The middle's, not a mean: between two things there is nothing.
        const float found = depth.depths[std::size_t(row) * std::size_t(depth.width) + std::size_t(column)];
        if (found > 0.0f) {
            values[i] = 1.0f / found;
            weights[i] = 1.0f;
        }
    }
    EdgeWeights even{grid.width, grid.height, std::vector<float>(values.size(), 1.0f), {}};
    even.down = even.right;
    const std::vector<float> around = smoothed(even, values, weights, {600.0, 3});
    for (std::size_t i = 0; i < values.size(); ++i)
        if (weights[i] == 0.0f)
            values[i] = around[i];
    return values;
}

Result<Shot> withGivenDepth(const Shot &shot, const std::vector<std::filesystem::path> &files,
                            const JobControl &control)
{
    DUCTUS_ASSERT(int(files.size()) == shot.frameCount());
    Shot taken = shot;
    if (shot.depths.empty())
        return taken; // a single picture is flat
    const DepthTaker taker(shot, files);
    const Result<double> factor = taker.factor(control);
    if (!factor)
        return factor.error();
    taken.depthFiles.clear();
    taken.isDepthGiven = true;
    for (int t = 0; t < shot.frameCount(); ++t) {
        if (control.isCancelled())
            return cancelledError(attempted);
        control.progress(double(t) / shot.frameCount(), attempted);
        Result<std::vector<float>> disparities = taker.disparities(t);
        if (!disparities)
            return disparities.error();
        for (float &disparity : *disparities)
            disparity = float(double(disparity) * *factor);
        const DepthMap &own = shot.depths[std::size_t(t)];
        DepthMap map = depthMapOf(own.width, own.height, own.cellSize, *disparities);
        map.objects = std::vector<std::uint8_t>(own.objects.begin(), own.objects.end());
        taken.depths[std::size_t(t)] = std::move(map);
    }
    return taken;
}

} // namespace ductus
