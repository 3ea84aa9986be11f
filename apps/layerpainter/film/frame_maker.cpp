#include "layerpainter/film/frame_maker.h"

#include "painting/reference/reference_frame.h"
#include "render/gl/offscreen_context.h"
#include "render/painting_renderer.h"

namespace ductus {

namespace {

class ExactFrames : public FrameMaker
{
public:
    ExactFrames(std::shared_ptr<const Painting> painting, const FrameOptions &options)
        : mPainting(std::move(painting)), mOptions(options)
    {
    }

    Result<Image> frame(const PaintingMoment &moment, const FrameCamera &camera,
                        const JobControl &control) override
    {
        ReferenceOptions options;
        options.width = mOptions.width;
        options.height = mOptions.height;
        options.samplesPerAxis = mOptions.samplesPerAxis;
        options.transparentBackground = mOptions.transparentBackground;
        options.moment = moment;
        Result<ReferenceFrame> frame = referenceFrame(*mPainting, camera, options, control);
        if (!frame)
            return frame.error();
        return std::move(frame->colour);
    }
    bool usesGraphics() const override { return false; }

private:
    std::shared_ptr<const Painting> mPainting;
    FrameOptions mOptions;
};

class DrawnFrames : public FrameMaker
{
public:
    DrawnFrames(std::shared_ptr<const Painting> painting, const FrameOptions &options,
                OffscreenContext context, PaintingRenderer renderer)
        : mPainting(std::move(painting)), mOptions(options), mContext(std::move(context)),
          mRenderer(std::move(renderer))
    {
    }

    Result<Image> frame(const PaintingMoment &moment, const FrameCamera &camera,
                        const JobControl &control) override
    {
        if (control.isCancelled())
            return cancelledError("Drawing the painting");
        if (mExact)
            return mExact->frame(moment, camera, control);
        Result<Image> image = drawn(moment, camera);
        if (!image && image.error().code == ErrorCode::TooLarge) {
            mExact = std::make_unique<ExactFrames>(mPainting, mOptions);
            return mExact->frame(moment, camera, control);
        }
        return image;
    }
    bool usesGraphics() const override { return !mExact; }

private:
    Result<Image> drawn(const PaintingMoment &moment, const FrameCamera &camera)
    {
        if (const Result<void> sent = mRenderer.update(*mPainting, moment); !sent)
            return sent.error();
        return mRenderer.image(camera, mOptions.width, mOptions.height);
    }

    std::shared_ptr<const Painting> mPainting;
    FrameOptions mOptions;
    OffscreenContext mContext; // outlives the renderer
    PaintingRenderer mRenderer;
    std::unique_ptr<ExactFrames> mExact; // once the card has refused
};

} // namespace

std::unique_ptr<FrameMaker> makeFrames(std::shared_ptr<const Painting> painting, const FrameOptions &options)
{
    if (!options.exact) {
        if (Result<OffscreenContext> context = OffscreenContext::create(); context) {
            RenderOptions rendering;
            rendering.samples = options.samplesPerAxis * options.samplesPerAxis;
            rendering.transparentBackground = options.transparentBackground;
            if (Result<PaintingRenderer> renderer = PaintingRenderer::create(rendering); renderer)
                return std::make_unique<DrawnFrames>(std::move(painting), options, std::move(*context),
                                                     std::move(*renderer));
        }
    }
    return std::make_unique<ExactFrames>(std::move(painting), options);
}

} // namespace ductus
