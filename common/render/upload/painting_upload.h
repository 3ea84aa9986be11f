// A painting at one time and in one look, on the graphics card: what changed since the last one is sent, the
// rest stays.
#pragma once

#include "painting/coverage/layer_solid.h"
#include "painting/reference/painting_solid.h"
#include "render/upload/card_arena.h"
#include "render/upload/element_table.h"
#include "render/upload/ribbon_chunks.h"
#include "render/upload/segment_instance.h"

#include <unordered_map>

namespace ductus {

/// Of the triangles of a box around a segment, and of a card that hides it.
constexpr std::uint32_t boxIndexCount = 36, cardIndexCount = 6;

/// A stroke or mesh, ready to be drawn.
struct DrawnElement
{
    std::uint32_t row = 0;
    bool isMesh = false;
    CardRange range;        // of segments, or of triangles
    CardRange coarse;       // of segments with fewer points; empty if there are none
    double coarseError = 0; // by how much they differ, scene units
    double widest = 0;      // half width of strokes, scene units
    double scale = 1;       // scene units in one of the shape's
    const ElementShape *shape = nullptr;
    std::uint64_t shapeVersion = 0; // another one is another shape
    Vec3 centre = Vec3::Zero();     // a ball around the skin, scene units
    double radius = 0;
    Eigen::Vector3f meanColour = Eigen::Vector3f::Zero(); // of meshes, linear RGB
};

struct DrawnLayer
{
    LayerId id;
    StackId stack;
    LayerProperties properties;
    double tolerance = 0;
    ToleranceMode toleranceMode = ToleranceMode::Surface;
    std::vector<DrawnElement> elements; // drawing order
    bool uniformColour = true;          // no stroke changes its colour along itself
    bool uniformOpacity = true;         // nor its opacity
    bool isTranslucent = false;         // what is behind shines through
    bool hasClearStrokes = false;       // strokes that are not opaque themselves
    bool hasMeshes = false;
    std::uint32_t sections = 0;   // bits of StrokeSection
    std::uint32_t orderCount = 0; // orders its elements have: 0..orderCount - 1
};

struct DrawnStack
{
    StackId id;
    DrawnLayer substrate;
    std::vector<DrawnLayer> appearance; // visible ones, bottom to top
};

/// Bytes sent to the card since the upload was made.
struct UploadedBytes
{
    std::uint64_t geometry = 0;
    std::uint64_t elements = 0; // placements and order
    std::uint64_t reach = 0;
    std::uint64_t total() const { return geometry + elements + reach; }
};

class PaintingUpload
{
public:
    /// InvalidArgument for a look that is not there, TooLarge when the card has no room.
    Result<void> update(const Painting &painting, const PaintingMoment &moment);

    const std::vector<DrawnStack> &stacks() const { return mStacks; } // visible ones
    const std::vector<DrawnLayer> &sceneLayers() const { return mSceneLayers; }
    /// Layers that masks name.
    const DrawnLayer *maskLayer(LayerId id) const;
    BlendSpace blendSpace() const { return mBlendSpace; }
    const Eigen::Vector3f &background() const { return mBackground; } // linear RGB

    /// Vertex arrays with the current buffers, bound; with the indices (16 bits) of a box's triangles, an
    /// instance each, and behind them those of a card's (segment_vertex.glsl).
    /// \a coarse: of DrawnElement::coarse, which have no reach.
    GLuint segmentArray(bool coarse, bool withReach);
    GLuint meshArray();
    GLuint triangleArray();
    void bindElements() const { mTable.bind(); }
    /// The substrates' strokes as ribbons, made when first asked for after an update.
    Result<void> prepareRibbons();
    RibbonChunks &ribbons() { return mRibbons; }

    UploadedBytes uploaded() const;
    std::uint32_t orderOf(const DrawnElement &element) const { return mTable.at(element.row).order; }

private:
    void addBoxIndices();
    struct Entry
    {
        std::shared_ptr<const ElementShape> shape; // kept, so that its address stays its name
        std::uint32_t row = 0;
        CardRange range;
        CardRange coarse;
        double coarseError = 0; // element's unit
        bool isMesh = false;
        StrokeSummary summary;
        Eigen::Vector3f meanColour = Eigen::Vector3f::Zero();
        std::uint64_t version = 0; // grows with every change of shape or place
        std::uint64_t shapeVersion = 0;
        std::uint64_t seen = 0; // the update that last met it
    };

    Result<DrawnLayer> drawn(const Layer &layer, const LayerProperties &properties, StackId stack,
                             const ElementPlacements &placements);
    Result<Entry *> entryOf(const Element &element);
    Result<void> sendStroke(const StrokeShape &stroke, Entry &entry);
    Result<CardRange> sendSegments(const std::vector<SegmentData> &segments, std::uint32_t row,
                                   CardArena &to);
    void giveRanges(const Entry &entry);
    Result<void> updateReaches(const Painting &painting, const ElementPlacements &placements);
    Result<void> writeReach(const DrawnLayer &layer, const LayerSolid &solid);
    std::uint64_t signatureOf(const DrawnLayer &layer) const;
    void dropUnseen(const Painting &painting);

    CardArena mSegments{sizeof(SegmentInstance)};
    CardArena mCoarse{sizeof(SegmentInstance)};
    CardArena mTriangles{3 * 24};
    RibbonChunks mRibbons;
    std::uint64_t mRibbonsUpdate = 0; // the update they were made after
    GlBuffer mBoxIndices;
    GlBuffer mReach; // as many as mSegments
    std::uint32_t mReachCapacity = 0;
    ElementTable mTable;
    std::unordered_map<std::int32_t, Entry> mEntries; // by element id
    std::map<LayerId, std::uint64_t> mReachSignatures;
    std::vector<DrawnStack> mStacks;
    std::vector<DrawnLayer> mSceneLayers;
    std::map<LayerId, DrawnLayer> mMaskLayers;
    BlendSpace mBlendSpace = BlendSpace::Encoded;
    Eigen::Vector3f mBackground = Eigen::Vector3f::Ones();
    GlVertexArray mSegmentArray, mReachArray, mMeshArray, mTriangleArray;
    std::uint64_t mUpdate = 0, mVersion = 0, mReachBytes = 0;
};

} // namespace ductus
