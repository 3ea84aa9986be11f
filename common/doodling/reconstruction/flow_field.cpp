#include "doodling/reconstruction/flow_field.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

cv::Mat greyOf(const Image &image)
{
    const cv::Mat rgba(image.height, image.width, CV_8UC4, const_cast<std::uint8_t *>(image.pixels.data()));
    cv::Mat grey;
    cv::cvtColor(rgba, grey, cv::COLOR_RGBA2GRAY);
    return grey;
}

cv::Mat flowBetween(const cv::Mat &from, const cv::Mat &to)
{
    const cv::Ptr<cv::DISOpticalFlow> method = cv::DISOpticalFlow::create(cv::DISOpticalFlow::PRESET_MEDIUM);
    method->setFinestScale(0); // of the full size: a fifth less error than the preset at three times the cost
    cv::Mat flow;
    method->calc(from, to, flow);
    return flow;
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

// The four cells around a place and their shares.
template <typename Value, typename Cells>
Value mixed(const FlowField &field, const Cells &cells, const Eigen::Vector2d &pixel)
{
    const double x = std::clamp(pixel.x() / field.cellSize - 0.5, 0.0, double(field.width - 1));
    const double y = std::clamp(pixel.y() / field.cellSize - 0.5, 0.0, double(field.height - 1));
    const int x0 = int(x), y0 = int(y);
    const int x1 = std::min(x0 + 1, field.width - 1), y1 = std::min(y0 + 1, field.height - 1);
    const double fx = x - x0, fy = y - y0;
    const auto at = [&](int cx, int cy) {
        return cells[std::size_t(cy) * std::size_t(field.width) + std::size_t(cx)];
    };
    return Value((at(x0, y0) * float(1 - fx) + at(x1, y0) * float(fx)) * float(1 - fy) +
                 (at(x0, y1) * float(1 - fx) + at(x1, y1) * float(fx)) * float(fy));
}

} // namespace

Eigen::Vector2d FlowField::motionAt(const Eigen::Vector2d &pixel) const
{
    return mixed<Eigen::Vector2f>(*this, motions, pixel).cast<double>();
}

double FlowField::confidenceAt(const Eigen::Vector2d &pixel) const
{
    return mixed<float>(*this, confidences, pixel);
}

FlowPair denseFlow(const Image &from, const Image &to, const FlowOptions &options)
{
    const cv::Mat greyFrom = greyOf(from), greyTo = greyOf(to);
    FlowPair pair{gridOf(flowBetween(greyFrom, greyTo), options.cellSize),
                  gridOf(flowBetween(greyTo, greyFrom), options.cellSize)};
    rateAgreement(pair.forward, pair.backward, options);
    rateAgreement(pair.backward, pair.forward, options);
    return pair;
}

} // namespace ductus
