#include "doodling/reconstruction/small_picture.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace ductus {

namespace {

// The four neighbours of a place in a grid whose cells are \a cellSize pixels wide, and their shares.
struct Neighbours
{
    int indices[4];
    float shares[4];
};

Neighbours neighboursOf(int width, int height, double cellSize, const Eigen::Vector2d &pixel)
{
    const double x = std::clamp(pixel.x() / cellSize - 0.5, 0.0, double(width - 1));
    const double y = std::clamp(pixel.y() / cellSize - 0.5, 0.0, double(height - 1));
    const int x0 = int(x), y0 = int(y);
    const int x1 = std::min(x0 + 1, width - 1), y1 = std::min(y0 + 1, height - 1);
    const float fx = float(x - x0), fy = float(y - y0);
    return {{y0 * width + x0, y0 * width + x1, y1 * width + x0, y1 * width + x1},
            {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy}};
}

} // namespace

Eigen::Vector3f SmallPicture::labAt(const Eigen::Vector2d &pixel) const
{
    Eigen::Vector3f lab = Eigen::Vector3f::Zero();
    const Neighbours light = neighboursOf(width, height, 2.0, pixel);
    const Neighbours colour = neighboursOf(colourWidth, colourHeight, 4.0, pixel);
    for (int i = 0; i < 4; ++i) {
        const std::uint8_t *ab = colours.data() + 2 * std::size_t(colour.indices[i]);
        lab.x() += light.shares[i] * lightness[std::size_t(light.indices[i])];
        lab.y() += colour.shares[i] * ab[0];
        lab.z() += colour.shares[i] * ab[1];
    }
    return lab;
}

SmallPicture smallPictureOf(const Image &image)
{
    const cv::Mat rgba(image.height, image.width, CV_8UC4, const_cast<std::uint8_t *>(image.pixels.data()));
    const cv::Size half(std::max(1, image.width / 2), std::max(1, image.height / 2));
    const cv::Size quarter(std::max(1, image.width / 4), std::max(1, image.height / 4));
    cv::Mat rgb, smaller, lab, light, colour, small;
    cv::cvtColor(rgba, rgb, cv::COLOR_RGBA2RGB);
    cv::resize(rgb, smaller, half, 0.0, 0.0, cv::INTER_AREA);
    cv::cvtColor(smaller, lab, cv::COLOR_RGB2Lab);
    cv::extractChannel(lab, light, 0);
    cv::resize(lab, small, quarter, 0.0, 0.0, cv::INTER_AREA);
    SmallPicture picture;
    picture.width = half.width;
    picture.height = half.height;
    picture.lightness = std::vector<std::uint8_t>(light.datastart, light.dataend);
    picture.colourWidth = quarter.width;
    picture.colourHeight = quarter.height;
    std::vector<std::uint8_t> colours;
    colours.reserve(2 * small.total());
    for (int y = 0; y < small.rows; ++y)
        for (int x = 0; x < small.cols; ++x) {
            const cv::Vec3b &value = small.at<cv::Vec3b>(y, x);
            colours.push_back(value[1]);
            colours.push_back(value[2]);
        }
    picture.colours = std::move(colours);
    return picture;
}

} // namespace ductus
