#include "doodling/compositing/coverage.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double nearest = 1e-3; // of the depth at the canvas' middle: what is nearer is cut off

double leastDepth(const CanvasView &view)
{
    return nearest * std::abs(view.depthOf(Vec2::Zero())) + 1e-12;
}

// An outline cut at the plane of least depth [Sutherland-Hodgman].
Outline cutAtCamera(const Outline &outline, const CanvasView &view)
{
    const double least = leastDepth(view);
    Outline result;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
        const double da = view.depthOf(a) - least, db = view.depthOf(b) - least;
        if (da >= 0.0)
            result.push_back(a);
        if ((da >= 0.0) != (db >= 0.0))
            result.push_back(a + da / (da - db) * (b - a));
    }
    return result;
}

struct Bounds
{
    Vec2 min = Vec2::Constant(1e300), max = Vec2::Constant(-1e300);

    void add(const Vec2 &p)
    {
        min = min.cwiseMin(p);
        max = max.cwiseMax(p);
    }
    PixelBox pixels(const PixelBox &limits) const
    {
        if (!(min.x() <= max.x()))
            return {};
        const auto whole = [](double v) { return int(std::clamp(v, -1e6, 1e6)); };
        return PixelBox{whole(std::floor(min.x() - 1.0)), whole(std::floor(min.y() - 1.0)),
                        whole(std::ceil(max.x() + 1.0)), whole(std::ceil(max.y() + 1.0))}
            .within(limits);
    }
};

// d pixel / d canvas at a point before the camera.
Eigen::Matrix2d derivative(const CanvasView &view, const Vec2 &point)
{
    const Eigen::Matrix3d &h = view.pixelFromCanvas();
    const Vec3 seen = h * point.homogeneous();
    const Vec2 pixel = seen.hnormalized();
    Eigen::Matrix2d result;
    for (int axis = 0; axis < 2; ++axis)
        result.col(axis) = (h.col(axis).head<2>() - pixel * h(2, axis)) / seen.z();
    return result;
}

double longest(const Eigen::Matrix2d &m)
{
    return m.norm(); // at most a root of 2 more than the greatest stretch
}

struct Node
{
    Vec2 onCanvas;
    Vec2 pixel;
    double radius = 0.0; // canvas units
};

// The line's points before the camera, in runs; ways over which the perspective bends in pieces short enough
// for it to be straight over each, and points closer than can be seen left out.
class Runs
{
public:
    Runs(const CanvasView &view, const PixelBox &limits)
        : mView(view), mLimits(limits), mLeast(leastDepth(view))
    {
    }

    std::vector<std::vector<Node>> of(const LinePiece::Line &line)
    {
        mRuns.assign(1, {});
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            if (i > 0)
                way(line.points[i - 1], line.radii[i - 1], line.points[i], line.radii[i], 0);
            add(line.points[i], line.radii[i], i == 0 || i + 1 == line.points.size());
        }
        return std::move(mRuns);
    }

private:
    // Adds what is needed strictly between two points.
    void way(const Vec2 &a, double ra, const Vec2 &b, double rb, int level)
    {
        constexpr double mostBend = 1.5, longestStep = 64.0; // ratio of depths; pixels, to keep boxes small
        constexpr int deepest = 12;
        const double da = mView.depthOf(a), db = mView.depthOf(b);
        if (level == deepest || std::max(da, db) < mLeast)
            return;
        if (std::min(da, db) >= mLeast) {
            const Vec2 pa = *mView.pixelOf(a), pb = *mView.pixelOf(b);
            const bool isBent = std::max(da, db) > mostBend * std::min(da, db);
            if (!(isBent || (pa - pb).norm() > longestStep) || isFarOutside(a, pa, ra, b, pb, rb))
                return;
        }
        const Vec2 middle = 0.5 * (a + b);
        const double radius = 0.5 * (ra + rb);
        way(a, ra, middle, radius, level + 1);
        add(middle, radius, false);
        way(middle, radius, b, rb, level + 1);
    }

    bool isFarOutside(const Vec2 &a, const Vec2 &pa, double ra, const Vec2 &b, const Vec2 &pb,
                      double rb) const
    {
        const double reach =
            1.0 + std::max(ra * longest(derivative(mView, a)), rb * longest(derivative(mView, b)));
        return std::max(pa.x(), pb.x()) < mLimits.left - reach ||
               std::min(pa.x(), pb.x()) > mLimits.right + reach ||
               std::max(pa.y(), pb.y()) < mLimits.top - reach ||
               std::min(pa.y(), pb.y()) > mLimits.bottom + reach;
    }

    void add(const Vec2 &point, double radius, bool isEnd)
    {
        constexpr double shortestStep = 0.6; // pixels
        if (mView.depthOf(point) < mLeast) {
            if (!mRuns.back().empty())
                mRuns.emplace_back();
            return;
        }
        const Vec2 pixel = *mView.pixelOf(point);
        std::vector<Node> &run = mRuns.back();
        if (!run.empty() && !isEnd && (run.back().pixel - pixel).norm() < shortestStep)
            return;
        run.push_back({point, pixel, radius});
    }

    const CanvasView &mView;
    PixelBox mLimits;
    double mLeast;
    std::vector<std::vector<Node>> mRuns;
};

// The pixels the brush touches on its way from a to b: those of the square around it, as far as it is before
// the camera.
Bounds boundsOf(const Node &a, const Node &b, const CanvasView &view)
{
    const double reach = std::max(a.radius, b.radius);
    const Vec2 low = a.onCanvas.cwiseMin(b.onCanvas) - Vec2::Constant(reach);
    const Vec2 high = a.onCanvas.cwiseMax(b.onCanvas) + Vec2::Constant(reach);
    Bounds bounds;
    for (const Vec2 &corner :
         cutAtCamera({low, Vec2(high.x(), low.y()), high, Vec2(low.x(), high.y())}, view))
        if (const std::optional<Vec2> pixel = view.pixelOf(corner))
            bounds.add(*pixel);
    return bounds;
}

// Paints the brush moved from a to b, by the larger share: every pixel's place on the canvas, and how far it
// is from the way in pixels as they are there.
void paintStep(const Node &a, const Node &b, const CanvasView &view, Coverage &coverage)
{
    const Eigen::Matrix3d &inverse = view.canvasFromPixel();
    const Vec2 way = b.onCanvas - a.onCanvas;
    const double squared = way.squaredNorm();
    const PixelBox box = boundsOf(a, b, view).pixels(coverage.box);
    for (int y = box.top; y < box.bottom; ++y) {
        float *row =
            coverage.shares.data() + std::size_t(y - coverage.box.top) * std::size_t(coverage.box.width());
        for (int x = box.left; x < box.right; ++x) {
            const Vec3 seen = inverse * Vec3(x + 0.5, y + 0.5, 1.0);
            if (!(seen.z() > 0.0))
                continue;
            const Vec2 point = seen.hnormalized();
            const double share =
                squared > 0.0 ? std::clamp((point - a.onCanvas).dot(way) / squared, 0.0, 1.0) : 0.0;
            const Vec2 off = point - a.onCanvas - share * way;
            const double radius = a.radius + share * (b.radius - a.radius);
            const double distance = off.norm();
            // Canvas units a pixel is wide in the direction of the distance.
            const Eigen::RowVector2d low = inverse.row(2).head<2>();
            const Eigen::Matrix2d step = (inverse.topLeftCorner<2, 2>() - point * low) / seen.z();
            const double pixel =
                distance > 1e-12 ? (step.transpose() * off).norm() / distance : step.col(0).norm();
            const double d = distance / pixel, r = radius / pixel;
            const double covered = std::min(0.5, r - d) + std::min(0.5, r + d);
            float &old = row[x - coverage.box.left];
            old = std::max(old, float(std::clamp(covered, 0.0, 1.0)));
        }
    }
}

// The area between an edge and the right border, as differences along the row [as font-rs does it].
class Accumulator
{
public:
    explicit Accumulator(const PixelBox &box)
        : mBox(box), mSums(std::size_t(box.width() + 2) * std::size_t(box.height()), 0.0f)
    {
    }

    void edge(Vec2 a, Vec2 b)
    {
        a -= Vec2(mBox.left, mBox.top);
        b -= Vec2(mBox.left, mBox.top);
        if (a.y() == b.y())
            return;
        const double direction = a.y() < b.y() ? 1.0 : -1.0;
        if (a.y() > b.y())
            std::swap(a, b);
        const double slope = (b.x() - a.x()) / (b.y() - a.y());
        const int first = std::max(0, int(std::floor(a.y())));
        const int last = std::min(mBox.height() - 1, int(std::ceil(b.y())) - 1);
        for (int y = first; y <= last; ++y) {
            const double top = std::max(double(y), a.y()), bottom = std::min(double(y + 1), b.y());
            if (bottom <= top)
                continue;
            const double x0 = a.x() + slope * (top - a.y()), x1 = a.x() + slope * (bottom - a.y());
            span(y, std::min(x0, x1), std::max(x0, x1), direction * (bottom - top));
        }
    }

    Coverage coverage() const
    {
        Coverage result{mBox, {}};
        result.shares.resize(std::size_t(mBox.width()) * std::size_t(mBox.height()));
        for (int y = 0; y < mBox.height(); ++y) {
            float sum = 0.0f;
            for (int x = 0; x < mBox.width(); ++x) {
                sum += mSums[std::size_t(y) * std::size_t(mBox.width() + 2) + std::size_t(x)];
                result.shares[std::size_t(y) * std::size_t(mBox.width()) + std::size_t(x)] =
                    std::min(1.0f, std::abs(sum));
            }
        }
        return result;
    }

private:
    // An edge over x0..x1 of row y, \a height of it high.
    void span(int y, double x0, double x1, double height)
    {
        const double right = mBox.width();
        x0 = std::clamp(x0, 0.0, right);
        x1 = std::clamp(x1, 0.0, right);
        float *row = mSums.data() + std::size_t(y) * std::size_t(mBox.width() + 2);
        const int first = int(x0), last = int(std::ceil(x1));
        if (last <= first + 1) { // within a pixel
            const double covered = 1.0 - (0.5 * (x0 + x1) - first);
            row[first] += float(height * covered);
            row[first + 1] += float(height * (1.0 - covered));
            return;
        }
        // The integral of what lies between the edge and b; pixel x is covered by its growth from x to x + 1.
        const auto integral = [&](double b) {
            return b <= x0 ? 0.0 : b < x1 ? 0.5 * (b - x0) * (b - x0) : (x1 - x0) * (b - 0.5 * (x0 + x1));
        };
        double before = 0.0;
        for (int x = first; x <= last; ++x) {
            const double covered = height / (x1 - x0) * (integral(x + 1) - integral(x));
            row[x] += float(covered - before);
            before = covered;
        }
    }

    PixelBox mBox;
    std::vector<float> mSums;
};

} // namespace

PixelBox PixelBox::within(const PixelBox &other) const
{
    return {std::max(left, other.left), std::max(top, other.top), std::min(right, other.right),
            std::min(bottom, other.bottom)};
}

PixelBox PixelBox::joined(const PixelBox &other) const
{
    if (isEmpty())
        return other;
    if (other.isEmpty())
        return *this;
    return {std::min(left, other.left), std::min(top, other.top), std::max(right, other.right),
            std::max(bottom, other.bottom)};
}

PixelBox boxOf(const MarkPiece &piece, const CanvasView &view, const PixelBox &limits)
{
    Bounds bounds;
    const auto addOutline = [&](const Outline &outline) {
        for (const Vec2 &point : cutAtCamera(outline, view))
            if (const std::optional<Vec2> pixel = view.pixelOf(point))
                bounds.add(*pixel);
    };
    if (const LinePiece *line = std::get_if<LinePiece>(&piece)) {
        for (const LinePiece::Line &one : line->lines)
            for (const std::vector<Node> &run : Runs(view, limits).of(one))
                for (const Node &node : run) {
                    const Bounds around = boundsOf(node, node, view);
                    bounds.add(around.min);
                    bounds.add(around.max);
                }
    } else if (const AreaPiece *area = std::get_if<AreaPiece>(&piece)) {
        for (const Outline &outline : area->outlines)
            addOutline(outline);
    } else {
        const PicturePiece &picture = std::get<PicturePiece>(piece);
        addOutline({picture.corner, picture.corner + picture.right,
                    picture.corner + picture.right + picture.down, picture.corner + picture.down});
    }
    return bounds.pixels(limits);
}

Coverage lineCoverage(const LinePiece &piece, const CanvasView &view, const PixelBox &limits)
{
    Coverage coverage{boxOf(piece, view, limits), {}};
    if (coverage.box.isEmpty())
        return coverage;
    coverage.shares.assign(std::size_t(coverage.box.width()) * std::size_t(coverage.box.height()), 0.0f);
    for (const LinePiece::Line &line : piece.lines)
        for (const std::vector<Node> &run : Runs(view, limits).of(line)) {
            if (run.size() == 1)
                paintStep(run[0], run[0], view, coverage);
            for (std::size_t i = 1; i < run.size(); ++i)
                paintStep(run[i - 1], run[i], view, coverage);
        }
    return coverage;
}

Coverage areaCoverage(const AreaPiece &piece, const CanvasView &view, const PixelBox &limits)
{
    const PixelBox box = boxOf(piece, view, limits);
    if (box.isEmpty())
        return {box, {}};
    Accumulator accumulator(box);
    for (const Outline &outline : piece.outlines) {
        std::vector<Vec2> pixels;
        for (const Vec2 &point : cutAtCamera(outline, view))
            if (const std::optional<Vec2> pixel = view.pixelOf(point))
                pixels.push_back(*pixel);
        for (std::size_t i = 0; i < pixels.size(); ++i)
            accumulator.edge(pixels[i], pixels[(i + 1) % pixels.size()]);
    }
    return accumulator.coverage();
}

} // namespace ductus
