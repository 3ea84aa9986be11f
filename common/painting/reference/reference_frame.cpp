#include "painting/reference/reference_frame.h"

#include "base/parallel.h"

#include <atomic>
#include <cmath>
#include <limits>

namespace ductus {

namespace {

Error invalid(const char *problem, const char *remedy)
{
    return {ErrorCode::InvalidArgument, "Drawing the painting", problem, remedy, ""};
}

Result<void> check(const FrameCamera &camera, const ReferenceOptions &options)
{
    if (options.width < 1 || options.height < 1 || options.width > 16384 || options.height > 16384)
        return invalid("the picture has no size that can be drawn", "Ask for 1 to 16384 pixels a side");
    if (options.samplesPerAxis < 1 || options.samplesPerAxis > 8)
        return invalid("the samples of a pixel are out of range", "Ask for 1 to 8 along each axis");
    if (!camera.isValid())
        return invalid("the camera stands nowhere or sees nothing",
                       "Give a finite place and a field of view");
    return {};
}

std::uint8_t byteOf(double value)
{
    return std::uint8_t(std::lround(255 * std::min(1.0, std::max(0.0, value))));
}

class FrameDrawing
{
public:
    FrameDrawing(const PaintingSolid &painting, const FrameCamera &camera, const ReferenceOptions &options)
        : mPainting(painting), mCamera(camera), mOptions(options), mSpace(painting.painting().blendSpace),
          mBackground(toBlendSpace(mSpace, painting.painting().background.cast<double>()))
    {
        const std::size_t count = std::size_t(options.width) * std::size_t(options.height);
        frame.colour = Image(options.width, options.height);
        frame.depth.assign(count, std::numeric_limits<float>::infinity());
        frame.stack.assign(count, -1);
        frame.element.assign(count, -1);
    }

    void drawRow(int y)
    {
        std::vector<SubstratePoint> points;
        const int n = mOptions.samplesPerAxis;
        for (int x = 0; x < mOptions.width; ++x) {
            PremultipliedColour sum;
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i) {
                    const Vec3 ray = mCamera.ray((x + (i + 0.5) / n) / mOptions.width,
                                                 (y + (j + 0.5) / n) / mOptions.height);
                    mPainting.surfaces(mCamera.eye, ray, mCamera.nearDepth, points);
                    const PremultipliedColour one = sample(points, ray);
                    sum.colour += one.colour / (n * n);
                    sum.alpha += one.alpha / (n * n);
                    if (i == n / 2 && j == n / 2 && !points.empty())
                        setIds(std::size_t(y) * std::size_t(mOptions.width) + std::size_t(x), points[0]);
                }
            frame.colour.set(x, y, straight(sum));
        }
    }

    ReferenceFrame frame;

private:
    PremultipliedColour sample(const std::vector<SubstratePoint> &points, const Vec3 &ray) const
    {
        PremultipliedColour colour;
        if (!mOptions.transparentBackground)
            colour = {mBackground, 1};
        for (std::size_t i = points.size(); i-- > 0;)
            colour = over({points[i].opacity * mPainting.colour(points[i], &ray), points[i].opacity}, colour);
        return colour;
    }

    void setIds(std::size_t pixel, const SubstratePoint &point)
    {
        frame.depth[pixel] = float(point.depth);
        frame.stack[pixel] = point.stackId.value;
        frame.element[pixel] = point.element.value;
    }

    Rgba straight(const PremultipliedColour &colour) const
    {
        if (colour.alpha <= 0)
            return {0, 0, 0, 0};
        Eigen::Vector3d value = colour.colour / colour.alpha;
        if (mSpace == BlendSpace::Linear)
            value = encodedFromLinear(value.cwiseMax(0).cwiseMin(1));
        return {byteOf(value[0]), byteOf(value[1]), byteOf(value[2]), byteOf(colour.alpha)};
    }

    const PaintingSolid &mPainting;
    const FrameCamera &mCamera;
    const ReferenceOptions &mOptions;
    BlendSpace mSpace;
    Eigen::Vector3d mBackground;
};

} // namespace

Result<ReferenceFrame> referenceFrame(const Painting &painting, const FrameCamera &camera,
                                      const ReferenceOptions &options, const JobControl &control)
{
    if (const Result<void> ok = check(camera, options); !ok)
        return ok.error();
    const Result<PaintingSolid> solid = PaintingSolid::make(painting, options.moment, control);
    if (!solid)
        return solid.error();
    return referenceFrame(*solid, camera, options, control);
}

Result<ReferenceFrame> referenceFrame(const PaintingSolid &painting, const FrameCamera &camera,
                                      const ReferenceOptions &options, const JobControl &control)
{
    if (const Result<void> ok = check(camera, options); !ok)
        return ok.error();
    FrameDrawing drawing(painting, camera, options);
    std::atomic<int> done{0};
    parallelFor(0, std::size_t(options.height), [&](std::size_t y) {
        if (control.isCancelled())
            return;
        drawing.drawRow(int(y));
        control.progress(double(++done) / options.height, "Drawing the painting");
    });
    if (control.isCancelled())
        return cancelledError("Drawing the painting");
    return std::move(drawing.frame);
}

} // namespace ductus
