#include "doodling/reconstruction/feature_grid.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace ductus {

namespace {

constexpr int cellPixels = 8;
// Parts reach over the cell's edge: a place at the edge of a cell is also known to its neighbour.
constexpr int partsASide = 3;
constexpr double partPixels = 4.0;

} // namespace

double FeatureGrid::distance(int cell, const FeatureGrid &other, int otherCell) const
{
    const std::uint8_t *a = values.data() + std::size_t(cell) * std::size_t(channels);
    const std::uint8_t *b = other.values.data() + std::size_t(otherCell) * std::size_t(channels);
    int sum = 0;
    for (int c = 0; c < channels; ++c)
        sum += (int(a[c]) - int(b[c])) * (int(a[c]) - int(b[c]));
    return double(sum) / channels;
}

int FeatureGrid::cellAt(double x, double y) const
{
    const int column = std::clamp(int(x / cellSize), 0, width - 1);
    const int row = std::clamp(int(y / cellSize), 0, height - 1);
    return row * width + column;
}

FeatureGrid featuresOf(const Image &image)
{
    const cv::Mat rgba(image.height, image.width, CV_8UC4, const_cast<std::uint8_t *>(image.pixels.data()));
    cv::Mat rgb, lab, smooth;
    cv::cvtColor(rgba, rgb, cv::COLOR_RGBA2RGB);
    cv::cvtColor(rgb, lab, cv::COLOR_RGB2Lab);
    cv::blur(lab, smooth, {int(partPixels), int(partPixels)});
    FeatureGrid grid;
    grid.cellSize = cellPixels;
    grid.width = std::max(1, image.width / cellPixels);
    grid.height = std::max(1, image.height / cellPixels);
    grid.channels = 3 * partsASide * partsASide;
    grid.values.reserve(std::size_t(grid.width) * std::size_t(grid.height) * std::size_t(grid.channels));
    for (int row = 0; row < grid.height; ++row)
        for (int column = 0; column < grid.width; ++column)
            for (int part = 0; part < partsASide * partsASide; ++part) {
                const double middleX = (column + 0.5) * cellPixels, middleY = (row + 0.5) * cellPixels;
                const int x = int(middleX + (part % partsASide - 1) * partPixels);
                const int y = int(middleY + (part / partsASide - 1) * partPixels);
                const cv::Vec3b &colour = smooth.at<cv::Vec3b>(std::clamp(y, 0, smooth.rows - 1),
                                                               std::clamp(x, 0, smooth.cols - 1));
                for (int c = 0; c < 3; ++c)
                    grid.values.push_back(colour[c]);
            }
    return grid;
}

} // namespace ductus
