#include "doodling/compositing/guided_mask.h"

#include "base/parallel.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

// Ten numbers a cell are averaged over windows: colour, its products, mask, mask times colour.
constexpr std::size_t channels = 3 + 6 + 1 + 3;
using Sums = std::array<float, channels>;
using Line = std::array<float, 4>; // value = line . (red, green, blue, 1)

template <std::size_t N>
std::vector<std::array<float, N>> windowMeans(const std::vector<std::array<float, N>> &values, int width,
                                              int height, int radius)
{
    std::vector<std::array<float, N>> rows(values.size()), result(values.size());
    const auto pass = [&](const auto &from, auto &to, int count, int lines, std::size_t step,
                          std::size_t lineStep) {
        for (int line = 0; line < lines; ++line) {
            const std::size_t base = std::size_t(line) * lineStep;
            std::array<double, N> sum{};
            int inside = 0;
            const auto add = [&](int i, double sign) {
                for (std::size_t c = 0; c < N; ++c)
                    sum[c] += sign * from[base + std::size_t(i) * step][c];
                inside += sign > 0.0 ? 1 : -1;
            };
            for (int i = 0; i < std::min(radius, count); ++i)
                add(i, 1.0);
            for (int i = 0; i < count; ++i) {
                if (i + radius < count)
                    add(i + radius, 1.0);
                if (i - radius - 1 >= 0)
                    add(i - radius - 1, -1.0);
                for (std::size_t c = 0; c < N; ++c)
                    to[base + std::size_t(i) * step][c] = float(sum[c] / inside);
            }
        }
    };
    pass(values, rows, width, height, 1, std::size_t(width));
    pass(rows, result, height, width, std::size_t(width), 1);
    return result;
}

// The least and greatest value within \a reach cells: what lies deep in one side of a mask stays there,
// however much its colours are those of the other side.
std::vector<std::array<float, 2>> limitsOf(const CoarseMask &mask, int reach)
{
    std::vector<std::array<float, 2>> rows(mask.values.size()), result(mask.values.size());
    const auto extend = [](std::array<float, 2> &to, float low, float high) {
        to = {std::min(to[0], low), std::max(to[1], high)};
    };
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x) {
            std::array<float, 2> &to = rows[std::size_t(y) * std::size_t(mask.width) + std::size_t(x)];
            to = {1.0f, 0.0f};
            for (int k = std::max(0, x - reach); k <= std::min(mask.width - 1, x + reach); ++k) {
                const float value = mask.values[std::size_t(y) * std::size_t(mask.width) + std::size_t(k)];
                extend(to, value, value);
            }
        }
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x) {
            std::array<float, 2> &to = result[std::size_t(y) * std::size_t(mask.width) + std::size_t(x)];
            to = {1.0f, 0.0f};
            for (int k = std::max(0, y - reach); k <= std::min(mask.height - 1, y + reach); ++k) {
                const std::array<float, 2> &row =
                    rows[std::size_t(k) * std::size_t(mask.width) + std::size_t(x)];
                extend(to, row[0], row[1]);
            }
        }
    return result;
}

// The picture's mean colour over a cell.
std::array<float, 3> colourOf(const Image &picture, const CoarseMask &mask, int cx, int cy)
{
    const auto range = [](double begin, double size, int limit) {
        const int first = std::clamp(int(std::floor(begin)), 0, limit - 1);
        const int last = std::clamp(int(std::ceil(begin + size)), first + 1, limit);
        return std::pair(first, last);
    };
    const auto [x0, x1] = range(mask.left + cx * mask.cellSize, mask.cellSize, picture.width);
    const auto [y0, y1] = range(mask.top + cy * mask.cellSize, mask.cellSize, picture.height);
    std::array<unsigned, 3> sum{};
    for (int y = y0; y < y1; ++y) {
        const std::uint8_t *p =
            picture.pixels.data() + 4 * (std::size_t(y) * std::size_t(picture.width) + std::size_t(x0));
        for (int x = x0; x < x1; ++x, p += 4)
            for (std::size_t c = 0; c < 3; ++c)
                sum[c] += p[c];
    }
    const float unit = 1.0f / (255.0f * float((x1 - x0) * (y1 - y0)));
    return {sum[0] * unit, sum[1] * unit, sum[2] * unit};
}

Line fitted(const Sums &mean, double epsilon)
{
    Eigen::Matrix3f scatter;
    scatter << mean[3], mean[4], mean[5], mean[4], mean[6], mean[7], mean[5], mean[7], mean[8];
    const Eigen::Vector3f colour(mean[0], mean[1], mean[2]);
    scatter -= colour * colour.transpose();
    scatter.diagonal().array() += float(epsilon);
    const Eigen::Vector3f covariance = Eigen::Vector3f(mean[10], mean[11], mean[12]) - mean[9] * colour;
    const Eigen::Vector3f slope = scatter.ldlt().solve(covariance);
    return {slope.x(), slope.y(), slope.z(), mean[9] - slope.dot(colour)};
}

} // namespace

std::vector<float> guidedMask(const CoarseMask &mask, const Image &picture, const PixelBox &box,
                              const GuideOptions &options)
{
    std::vector<Sums> sums(mask.values.size());
    parallelFor(
        0, std::size_t(mask.height),
        [&](std::size_t y) {
            for (int x = 0; x < mask.width; ++x) {
                const std::size_t cell = y * std::size_t(mask.width) + std::size_t(x);
                const std::array<float, 3> c = colourOf(picture, mask, x, int(y));
                const float m = mask.values[cell];
                sums[cell] = {c[0],        c[1],        c[2],        c[0] * c[0], c[0] * c[1],
                              c[0] * c[2], c[1] * c[1], c[1] * c[2], c[2] * c[2], m,
                              m * c[0],    m * c[1],    m * c[2]};
            }
        },
        8);
    const std::vector<Sums> means = windowMeans(sums, mask.width, mask.height, options.radius);
    std::vector<Line> lines(means.size());
    for (std::size_t i = 0; i < means.size(); ++i)
        lines[i] = fitted(means[i], options.epsilon);
    lines = windowMeans(lines, mask.width, mask.height, options.radius);
    const std::vector<std::array<float, 2>> limits = limitsOf(mask, options.reach);

    std::vector<float> result(std::size_t(box.width()) * std::size_t(box.height()));
    parallelFor(
        0, std::size_t(box.height()),
        [&](std::size_t row) {
            const int y = box.top + int(row);
            const double cy = std::clamp((y + 0.5 - mask.top) / mask.cellSize - 0.5, 0.0, mask.height - 1.0);
            const int low = std::min(int(cy), std::max(0, mask.height - 2)),
                      high = std::min(low + 1, mask.height - 1);
            const float down = float(cy - low);
            for (int x = box.left; x < box.right; ++x) {
                const double cx =
                    std::clamp((x + 0.5 - mask.left) / mask.cellSize - 0.5, 0.0, mask.width - 1.0);
                const int left = std::min(int(cx), std::max(0, mask.width - 2)),
                          right = std::min(left + 1, mask.width - 1);
                const float along = float(cx - left);
                const auto line = [&](int lx, int ly) -> const Line & {
                    return lines[std::size_t(ly) * std::size_t(mask.width) + std::size_t(lx)];
                };
                const Line &a = line(left, low), &b = line(right, low), &c = line(left, high),
                           &d = line(right, high);
                const std::uint8_t *p = picture.pixels.data() +
                                        4 * (std::size_t(y) * std::size_t(picture.width) + std::size_t(x));
                float value = 0.0f;
                for (std::size_t k = 0; k < 4; ++k) {
                    const float top = a[k] + along * (b[k] - a[k]), bottom = c[k] + along * (d[k] - c[k]);
                    value += (top + down * (bottom - top)) * (k < 3 ? p[k] / 255.0f : 1.0f);
                }
                const std::array<float, 2> &limit =
                    limits[std::size_t(down < 0.5f ? low : high) * std::size_t(mask.width) +
                           std::size_t(along < 0.5f ? left : right)];
                result[row * std::size_t(box.width()) + std::size_t(x - box.left)] =
                    std::clamp(value, limit[0], limit[1]);
            }
        },
        8);
    return result;
}

} // namespace ductus
