#include "doodling/reconstruction/cameras/point_tracks.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include <algorithm>

namespace ductus {

namespace {

constexpr int windowPixels = 17;
constexpr int levels = 1; // the flow has found the way, large steps need no pyramid

cv::Point2f toCv(const Vec2 &pixel)
{
    return {float(pixel.x() - 0.5), float(pixel.y() - 0.5)}; // OpenCV's whole numbers are middles
}

Vec2 fromCv(const cv::Point2f &point)
{
    return {double(point.x) + 0.5, double(point.y) + 0.5};
}

} // namespace

struct PointTracker::State
{
    PointTrackOptions options;
    cv::Mat before;
    int frameCount = 0;
    std::vector<PointTrack> active, ended;

    void follow(const cv::Mat &grey, const CompactFlow &flow);
    void addCorners(const cv::Mat &grey);
    void end(PointTrack track)
    {
        if (int(track.pixels.size()) >= options.shortest)
            ended.push_back(std::move(track));
    }
};

void PointTracker::State::follow(const cv::Mat &grey, const CompactFlow &flow)
{
    if (active.empty())
        return;
    std::vector<cv::Point2f> from, to, back;
    for (const PointTrack &track : active) {
        from.push_back(toCv(track.pixels.back()));
        to.push_back(toCv(track.pixels.back() + flow.motionAt(track.pixels.back())));
    }
    back = from;
    const std::vector<cv::Point2f> guess = to;
    std::vector<std::uint8_t> found, foundBack;
    const cv::TermCriteria stop(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 20, 0.01);
    const cv::Size window(windowPixels, windowPixels);
    cv::calcOpticalFlowPyrLK(before, grey, from, to, found, cv::noArray(), window, levels, stop,
                             cv::OPTFLOW_USE_INITIAL_FLOW);
    cv::calcOpticalFlowPyrLK(grey, before, to, back, foundBack, cv::noArray(), window, levels, stop,
                             cv::OPTFLOW_USE_INITIAL_FLOW);
    std::vector<PointTrack> kept;
    for (std::size_t i = 0; i < active.size(); ++i) {
        const Vec2 pixel = fromCv(to[i]);
        const bool isInside =
            pixel.x() > 2.0 && pixel.y() > 2.0 && pixel.x() < grey.cols - 2.0 && pixel.y() < grey.rows - 2.0;
        const bool isGood = found[i] && foundBack[i] && isInside &&
                            cv::norm(back[i] - from[i]) < options.mostReturnMiss &&
                            cv::norm(to[i] - guess[i]) < options.mostFlowMiss;
        if (isGood) {
            active[i].pixels.push_back(pixel);
            kept.push_back(std::move(active[i]));
        } else {
            end(std::move(active[i]));
        }
    }
    active = std::move(kept);
}

void PointTracker::State::addCorners(const cv::Mat &grey)
{
    const double spacing = std::max(4.0, options.spacingShare * grey.cols);
    cv::Mat mask(grey.size(), CV_8U, cv::Scalar(255));
    for (const PointTrack &track : active)
        cv::circle(mask, cv::Point(toCv(track.pixels.back())), int(spacing), cv::Scalar(0), -1);
    std::vector<cv::Point2f> corners;
    cv::goodFeaturesToTrack(grey, corners, 0, options.quality, spacing, mask, 5);
    for (const cv::Point2f &corner : corners)
        active.push_back({frameCount, {fromCv(corner)}});
}

PointTracker::PointTracker(const PointTrackOptions &options) : mState(std::make_unique<State>())
{
    mState->options = options;
}

PointTracker::~PointTracker() = default;

void PointTracker::add(const Image &frame, const CompactFlow *fromPrevious)
{
    const cv::Mat rgba(frame.height, frame.width, CV_8UC4, const_cast<std::uint8_t *>(frame.pixels.data()));
    cv::Mat grey;
    cv::cvtColor(rgba, grey, cv::COLOR_RGBA2GRAY);
    if (fromPrevious && !mState->before.empty())
        mState->follow(grey, *fromPrevious);
    mState->addCorners(grey);
    mState->before = grey;
    ++mState->frameCount;
}

std::vector<PointTrack> PointTracker::takeTracks()
{
    for (PointTrack &track : mState->active)
        mState->end(std::move(track));
    mState->active.clear();
    std::vector<PointTrack> tracks = std::move(mState->ended);
    mState->ended.clear();
    std::stable_sort(tracks.begin(), tracks.end(),
                     [](const PointTrack &a, const PointTrack &b) { return a.firstFrame < b.firstFrame; });
    return tracks;
}

} // namespace ductus
