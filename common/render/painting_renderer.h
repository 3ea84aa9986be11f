// Draws paintings with OpenGL: the frames of common/painting/reference, fast. painting.md section 3.
//
//     Result<PaintingRenderer> renderer = PaintingRenderer::create({});     // in the current context
//     renderer->update(painting, {time, look});                            // what changed goes to the card
//     renderer->render({{camera, framebuffer, 0, 0, width, height}});      // any number of views
//
// All functions want the context current in which the renderer was made, the destructor too. They leave
// program, vertex array, textures and buffers unbound, blending, depth and scissor tests off; the viewport
// and the framebuffer are the caller's to set again.
#pragma once

#include "base/result.h"
#include "imaging/image.h"
#include "painting/reference/frame_camera.h"
#include "painting/reference/painting_solid.h"

#include <memory>
#include <span>

namespace ductus {

struct RenderOptions
{
    int samples = 1;                    // of each pixel; each is decided for itself
    bool transparentBackground = false; // straight alpha
    // 0 for both gives the reference's frames; windows may ask for about 0.5.
    double smallestPixels = 0; // strokes that are smaller across are left out
    double errorPixels = 0;    // strokes without tolerance may be drawn with fewer points, this much off
    // For large paintings while the view turns, else 0: strokes of shapes that are no wider than this to each
    // side are drawn as ribbons, of which no more than so many vertices; where that is too few for all
    // strokes, some grow wider and stand for the others.
    double ribbonPixels = 0;
    int ribbonVertices = 0;
};

struct RenderView
{
    FrameCamera camera;
    std::uint32_t framebuffer =
        0;                     // OpenGL's name of what to draw onto; 8 bits a channel, not sRGB-converting
    int x = 0, y = 0;          // lower left corner there
    int width = 0, height = 0; // pixels
};

/// What a frame cost.
struct RenderStatistics
{
    int draws = 0;
    std::uint64_t segments = 0; // of strokes, all views
    std::uint64_t ribbonVertices = 0;
    std::uint64_t geometryBytes = 0; // sent to the card since the renderer was made
    std::uint64_t elementBytes = 0;  // placements and order, likewise
    std::uint64_t reachBytes = 0;    // directions of tolerance, likewise
};

/// What is seen at a pixel.
struct PickedPoint
{
    StackId stack;
    ElementId element; // of the substrate
    Vec3 position;     // scene units
    double depth = 0;  // along the view
};

/// The card's own record of a frame, for what is drawn over it: RG32UI, in the first part the stack (0:
/// nothing), in the second the bits of the depth along the view, rows from the bottom.
struct SeenSurface
{
    std::uint32_t texture = 0; // multisampled if there are several samples
    int samples = 1;
};

class PaintingRenderer
{
public:
    /// Unsupported without OpenGL 4.3.
    static Result<PaintingRenderer> create(const RenderOptions &options);
    PaintingRenderer(PaintingRenderer &&) noexcept;
    PaintingRenderer &operator=(PaintingRenderer &&) noexcept;
    ~PaintingRenderer();

    const RenderOptions &options() const;
    void setOptions(const RenderOptions &options);

    /// Takes the painting as it is at a moment. Shapes are told apart by address; only new ones are sent, for
    /// moved ones their placement, for properties of layers nothing. InvalidArgument for a look that is not
    /// there, TooLarge when the card has no room.
    Result<void> update(const Painting &painting, const PaintingMoment &moment);

    /// InvalidArgument for a view without size or with an invalid camera, TooLarge beyond the card's limits.
    Result<void> render(std::span<const RenderView> views);

    /// A frame on its own: rows from the top, straight sRGB and alpha.
    Result<Image> image(const FrameCamera &camera, int width, int height);

    /// What the last frame shows at a pixel of its view number \a view, rows from the top; none for the
    /// background. Waits for the card. For the layers that colour the point see PaintingSolid::coloursAt.
    Result<std::optional<PickedPoint>> pick(std::size_t view, int x, int y);

    /// Of the last frame's view number \a view; good until the next frame.
    std::optional<SeenSurface> seenSurface(std::size_t view) const;

    /// Of the last frame.
    RenderStatistics statistics() const;

private:
    struct Parts;
    explicit PaintingRenderer(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> mParts;
};

} // namespace ductus
