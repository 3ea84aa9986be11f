#include "doodling/reconstruction/rough_match.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace ductus {

namespace {

constexpr int mostLevels = 5;
constexpr int smallestSide = 24; // pixels of a level

// Edges in units of the contrast around: the same in shade and sun.
cv::Mat placesOf(const cv::Mat &lab)
{
    cv::Mat whole;
    lab.convertTo(whole, CV_32FC3);
    std::vector<cv::Mat> parts;
    cv::split(whole, parts);
    const cv::Mat &light = parts[0];
    cv::Mat gx, gy, length, contrast, around;
    cv::Sobel(light, gx, CV_32F, 1, 0, 3, 0.125);
    cv::Sobel(light, gy, CV_32F, 0, 1, 3, 0.125);
    cv::sqrt(gx.mul(gx) + gy.mul(gy), length);
    cv::GaussianBlur(length, contrast, {}, 4.0);
    contrast += 4.0; // grey levels: what is flat stays flat
    gx = 40.0 * gx / contrast;
    gy = 40.0 * gy / contrast;
    cv::GaussianBlur(light, around, {}, 8.0);
    const std::vector<cv::Mat> channels{cv::max(gx, 0.0),
                                        cv::max(-gx, 0.0),
                                        cv::max(gy, 0.0),
                                        cv::max(-gy, 0.0),
                                        0.5 * (light - around) + 100.0,
                                        0.25 * light,
                                        parts[1],
                                        parts[2]};
    std::vector<cv::Mat> bytes(channels.size());
    for (std::size_t i = 0; i < channels.size(); ++i) {
        cv::Mat smooth;
        cv::GaussianBlur(channels[i], smooth, {}, 1.0);
        smooth.convertTo(bytes[i], CV_8U);
    }
    cv::Mat places;
    cv::merge(bytes, places);
    return places;
}

WindowPyramid::Level levelOf(const cv::Mat &lab)
{
    constexpr int border = WindowPyramid::placeStep;
    cv::Mat places;
    cv::copyMakeBorder(placesOf(lab), places, border, border, border, border, cv::BORDER_REPLICATE);
    return {lab.cols, lab.rows,
            std::vector<std::uint8_t>(places.ptr(), places.ptr() + places.total() * places.elemSize())};
}

} // namespace

WindowPyramid windowPyramidOf(const Image &image)
{
    const cv::Mat rgba(image.height, image.width, CV_8UC4, const_cast<std::uint8_t *>(image.pixels.data()));
    cv::Mat rgb, half, lab;
    cv::cvtColor(rgba, rgb, cv::COLOR_RGBA2RGB);
    cv::resize(rgb, half, {std::max(1, image.width / 2), std::max(1, image.height / 2)}, 0.0, 0.0,
               cv::INTER_AREA);
    cv::cvtColor(half, lab, cv::COLOR_RGB2Lab);
    WindowPyramid pyramid;
    pyramid.width = image.width;
    pyramid.height = image.height;
    for (int i = 0; i < mostLevels; ++i) {
        pyramid.levels.push_back(levelOf(lab));
        if (std::min(lab.cols, lab.rows) / 2 < smallestSide)
            break;
        cv::Mat next;
        cv::resize(lab, next, {lab.cols / 2, lab.rows / 2}, 0.0, 0.0, cv::INTER_AREA);
        lab = next;
    }
    return pyramid;
}

} // namespace ductus
