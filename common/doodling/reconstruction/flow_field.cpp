#include "doodling/reconstruction/flow_field.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include <algorithm>
#include <cmath>
#include <mutex>

namespace ductus {

namespace {

constexpr int smallestSide = 16; // pixels that the exact flow can work on
// The preset has 3 and 25: on the tennis clip these agree as well with RAFT in 0.6 of the time.
constexpr int patchStride = 4;
constexpr int descentSteps = 12;

cv::Mat greyOf(const Image &image)
{
    const cv::Mat rgba(image.height, image.width, CV_8UC4, const_cast<std::uint8_t *>(image.pixels.data()));
    cv::Mat grey;
    cv::cvtColor(rgba, grey, cv::COLOR_RGBA2GRAY);
    return grey;
}

// Patches start from the rough motion where it fits better than what coarser levels found ("temporal
// candidates" in OpenCV's words).
cv::Mat flowBetween(cv::DISOpticalFlow &method, const FlowPicture &from, const FlowPicture &to,
                    const RoughMotion &start, const FlowOptions &options)
{
    const auto matOf = [](const FlowPicture &picture) {
        return cv::Mat(picture.height, picture.width, CV_8U, const_cast<std::uint8_t *>(picture.grey.data()));
    };
    const cv::Mat grid(start.height, start.width, CV_32FC2,
                       const_cast<Eigen::Vector2f *>(start.motions.data()));
    cv::Mat flow;
    cv::resize(grid, flow, {from.width, from.height}, 0.0, 0.0, cv::INTER_NEAREST);
    if (std::min(from.width, from.height) < smallestSide)
        return flow;
    method.setFinestScale(options.isFullSize ? 0 : 1);
    method.calc(matOf(from), matOf(to), flow);
    return flow;
}

// Its stripes, and so its answer, depend on how many threads OpenCV has; pairs are worked on side by side
// instead.
void useOneThreadAPair()
{
    static std::once_flag once;
    std::call_once(once, [] { cv::setNumThreads(1); });
}

FlowField gridOf(const cv::Mat &flow, int cellSize)
{
    FlowField field;
    field.width = (flow.cols + cellSize - 1) / cellSize;
    field.height = (flow.rows + cellSize - 1) / cellSize;
    field.cellSize = cellSize;
    field.motions.reserve(std::size_t(field.width) * std::size_t(field.height));
    for (int y = 0; y < field.height; ++y)
        for (int x = 0; x < field.width; ++x) {
            // The cell's middle, not its mean: a mean over a silhouette is the motion of neither side.
            const int px = std::min(flow.cols - 1, x * cellSize + cellSize / 2);
            const int py = std::min(flow.rows - 1, y * cellSize + cellSize / 2);
            const cv::Vec2f &v = flow.at<cv::Vec2f>(py, px);
            const bool isNumber = std::isfinite(v[0]) && std::isfinite(v[1]);
            field.motions.emplace_back(isNumber ? v[0] : 0.0f, isNumber ? v[1] : 0.0f);
        }
    return field;
}

void rateAgreement(FlowField &field, const FlowField &back, const FlowOptions &options)
{
    field.confidences.clear();
    field.confidences.reserve(field.motions.size());
    const Eigen::Vector2d size(field.width * field.cellSize, field.height * field.cellSize);
    for (int y = 0; y < field.height; ++y)
        for (int x = 0; x < field.width; ++x) {
            const Eigen::Vector2d pixel = Eigen::Vector2d(x + 0.5, y + 0.5) * field.cellSize;
            const Eigen::Vector2d motion =
                field.motions[std::size_t(y) * std::size_t(field.width) + std::size_t(x)].cast<double>();
            const Eigen::Vector2d there = pixel + motion;
            const bool leaves = (there.array() < 0.0).any() || (there.array() > size.array()).any();
            const double miss = (motion + back.motionAt(there)).norm();
            const double half = options.halfTrust + options.halfTrustShare * motion.norm();
            field.confidences.push_back(leaves ? 0.0f : float(1.0 / (1.0 + (miss / half) * (miss / half))));
        }
}

} // namespace

GridPlace::GridPlace(const Eigen::Vector2d &pixel, double cellSize, int width, int height)
{
    const double x = std::clamp(pixel.x() / cellSize - 0.5, 0.0, double(width - 1));
    const double y = std::clamp(pixel.y() / cellSize - 0.5, 0.0, double(height - 1));
    const int x0 = int(x), y0 = int(y);
    const int x1 = std::min(x0 + 1, width - 1), y1 = std::min(y0 + 1, height - 1);
    const double fx = x - x0, fy = y - y0;
    const auto cell = [&](int cx, int cy) { return std::size_t(cy) * std::size_t(width) + std::size_t(cx); };
    cells[0] = cell(x0, y0);
    cells[1] = cell(x1, y0);
    cells[2] = cell(x0, y1);
    cells[3] = cell(x1, y1);
    shares[0] = (1 - fx) * (1 - fy);
    shares[1] = fx * (1 - fy);
    shares[2] = (1 - fx) * fy;
    shares[3] = fx * fy;
}

Eigen::Vector2d FlowField::motionAt(const Eigen::Vector2d &pixel) const
{
    const GridPlace place(pixel, cellSize, width, height);
    Eigen::Vector2d motion = Eigen::Vector2d::Zero();
    for (int i = 0; i < 4; ++i)
        motion += place.shares[i] * motions[place.cells[i]].cast<double>();
    return motion;
}

double FlowField::confidenceAt(const Eigen::Vector2d &pixel) const
{
    const GridPlace place(pixel, cellSize, width, height);
    double confidence = 0.0;
    for (int i = 0; i < 4; ++i)
        confidence += place.shares[i] * double(confidences[place.cells[i]]);
    return confidence;
}

MotionAt FlowField::at(const Eigen::Vector2d &pixel) const
{
    const GridPlace place(pixel, cellSize, width, height);
    MotionAt at;
    for (int i = 0; i < 4; ++i) {
        at.motion += place.shares[i] * motions[place.cells[i]].cast<double>();
        at.confidence += place.shares[i] * double(confidences[place.cells[i]]);
    }
    return at;
}

double missOf(const MotionAt &at, const FlowOptions &options)
{
    const double half = options.halfTrust + options.halfTrustShare * at.motion.norm();
    return half * std::sqrt(1.0 / std::clamp(at.confidence, 1e-3, 1.0) - 1.0);
}

FlowPicture flowPictureOf(const Image &image)
{
    const cv::Mat grey = greyOf(image);
    return {image.width, image.height, std::vector<std::uint8_t>(grey.datastart, grey.dataend),
            windowPyramidOf(image)};
}

struct FlowFinder::State
{
    cv::Ptr<cv::DISOpticalFlow> method;
};

FlowFinder::FlowFinder() : mState(std::make_unique<State>())
{
    useOneThreadAPair();
    mState->method = cv::DISOpticalFlow::create(cv::DISOpticalFlow::PRESET_MEDIUM);
    mState->method->setPatchStride(patchStride);
    mState->method->setGradientDescentIterations(descentSteps);
}

FlowFinder::~FlowFinder() = default;
FlowFinder::FlowFinder(FlowFinder &&) noexcept = default;

FlowPair FlowFinder::find(const FlowPicture &from, const FlowPicture &to, const FlowOptions &options)
{
    const RoughMotionPair rough = roughMotion(from.windows, to.windows);
    cv::DISOpticalFlow &method = *mState->method;
    FlowPair pair{gridOf(flowBetween(method, from, to, rough.forward, options), options.cellSize),
                  gridOf(flowBetween(method, to, from, rough.backward, options), options.cellSize)};
    rateAgreement(pair.forward, pair.backward, options);
    rateAgreement(pair.backward, pair.forward, options);
    return pair;
}

FlowPair denseFlow(const FlowPicture &from, const FlowPicture &to, const FlowOptions &options)
{
    return FlowFinder().find(from, to, options);
}

FlowPair denseFlow(const Image &from, const Image &to, const FlowOptions &options)
{
    return denseFlow(flowPictureOf(from), flowPictureOf(to), options);
}

} // namespace ductus
