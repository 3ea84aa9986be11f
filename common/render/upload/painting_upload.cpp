#include "render/upload/painting_upload.h"

#include "painting/coverage/reach.h"
#include "painting/coverage/stroke_segments.h"
#include "render/gl/gl_error.h"
#include "render/upload/coarse_stroke.h"
#include "render/upload/mesh_vertex.h"

#include <algorithm>

namespace ductus {

namespace {

bool isShown(const LayerProperties &properties)
{
    return properties.visible && properties.opacity > 0;
}

std::uint64_t mixed(std::uint64_t hash, std::uint64_t value) // FNV-1a on words
{
    return (hash ^ value) * 1099511628211ull;
}

/// The properties of layers in a look.
class LookedUp
{
public:
    explicit LookedUp(const Look *look)
    {
        if (look)
            for (const auto &[layer, properties] : look->layers)
                mProperties.emplace(layer, &properties);
    }
    const LayerProperties &of(const Layer &layer) const
    {
        const auto found = mProperties.find(layer.id);
        return found == mProperties.end() ? layer.properties : *found->second;
    }

private:
    std::map<LayerId, const LayerProperties *> mProperties;
};

} // namespace

Result<void> PaintingUpload::update(const Painting &painting, const PaintingMoment &moment)
{
    const Look *look = moment.look ? painting.findLook(*moment.look) : nullptr;
    if (moment.look && !look)
        return Error{ErrorCode::InvalidArgument,
                     "Drawing the painting",
                     "the painting has no such look",
                     "Choose one of its looks",
                     {}};
    const LookedUp looked(look);
    const ElementPlacements placements(painting, moment.timeSeconds);
    ++mUpdate;
    mBlendSpace = painting.blendSpace;
    mBackground = painting.background;
    mStacks.clear();
    mSceneLayers.clear();
    mMaskLayers.clear();

    std::vector<LayerId> maskLayers;
    const auto addLayer = [&](const Layer &layer, StackId stack,
                              std::vector<DrawnLayer> &to) -> Result<void> {
        const LayerProperties &properties = looked.of(layer);
        if (!isShown(properties))
            return {};
        Result<DrawnLayer> made = drawn(layer, properties, stack, placements);
        if (!made)
            return made.error();
        to.push_back(std::move(*made));
        for (const Mask &mask : properties.masks)
            if (const auto *strokes = std::get_if<StrokeMask>(&mask.shape); strokes && mask.enabled)
                maskLayers.push_back(strokes->layer);
        return {};
    };
    for (const Stack &stack : painting.stacks) {
        if (!isShown(looked.of(*stack.substrate)))
            continue;
        std::vector<DrawnLayer> substrate;
        DrawnStack made;
        made.id = stack.id;
        if (Result<void> done = addLayer(*stack.substrate, stack.id, substrate); !done)
            return done;
        made.substrate = std::move(substrate[0]);
        for (const Layer &layer : stack.appearance)
            if (Result<void> done = addLayer(layer, stack.id, made.appearance); !done)
                return done;
        mStacks.push_back(std::move(made));
    }
    for (const Layer &layer : painting.sceneStack.appearance)
        if (Result<void> done = addLayer(layer, sceneStackId, mSceneLayers); !done)
            return done;
    for (const LayerId id : maskLayers) {
        const Layer *layer = painting.findLayer(id);
        if (!layer || mMaskLayers.contains(id))
            continue;
        Result<DrawnLayer> made = drawn(*layer, looked.of(*layer), painting.stackOf(id)->id, placements);
        if (!made)
            return made.error();
        mMaskLayers.emplace(id, std::move(*made));
    }
    dropUnseen(painting);
    if (Result<void> done = updateReaches(painting, placements); !done)
        return done;
    if (Result<void> done = mTable.upload(); !done)
        return done;
    return checkGl("Uploading the painting");
}

const DrawnLayer *PaintingUpload::maskLayer(LayerId id) const
{
    const auto found = mMaskLayers.find(id);
    return found == mMaskLayers.end() ? nullptr : &found->second;
}

Result<DrawnLayer> PaintingUpload::drawn(const Layer &layer, const LayerProperties &properties, StackId stack,
                                         const ElementPlacements &placements)
{
    DrawnLayer made;
    made.id = layer.id;
    made.stack = stack;
    made.properties = properties;
    made.tolerance = layer.tolerance;
    made.toleranceMode = layer.toleranceMode;
    made.isTranslucent = properties.opacity < 1;
    const Drawing &drawing = layer.drawingAt(placements.timeSeconds());
    made.elements.reserve(drawing.elements.size());
    made.orderCount = std::uint32_t(drawing.elements.size());
    for (std::size_t i = 0; i < drawing.elements.size(); ++i) {
        const Element &element = drawing.elements[i];
        Result<Entry *> entry = entryOf(element);
        if (!entry)
            return entry.error();
        Entry &known = **entry;
        const Placement place = placements.sceneFromElement(layer, element);
        const ElementRow row = ElementRow::of(place, element.id, std::uint32_t(i), stack);
        if (mTable.set(known.row, row))
            known.version = ++mVersion;
        if (known.range.count == 0)
            continue;
        const StrokeSummary &summary = known.summary;
        DrawnElement drawn;
        drawn.row = known.row;
        drawn.isMesh = known.isMesh;
        drawn.range = known.range;
        drawn.coarse = known.coarse;
        drawn.coarseError = known.coarseError * place.scale;
        drawn.widest = 2 * drawn.coarseError;
        drawn.scale = place.scale;
        drawn.shape = known.shape.get();
        drawn.shapeVersion = known.shapeVersion;
        drawn.centre = place.matrix() * summary.box.centre();
        drawn.radius = 0.5 * summary.box.diagonal() * place.scale;
        drawn.meanColour = known.meanColour;
        made.elements.push_back(drawn);
        made.uniformColour &= summary.uniformColour;
        made.uniformOpacity &= summary.uniformOpacity;
        made.isTranslucent |= summary.leastOpacity < 1;
        made.hasClearStrokes |= summary.leastOpacity < 1;
        made.hasMeshes |= known.isMesh;
        made.sections |= summary.sections;
    }
    made.uniformColour |= properties.colour.has_value();
    return made;
}

Result<PaintingUpload::Entry *> PaintingUpload::entryOf(const Element &element)
{
    const auto [found, isNew] = mEntries.try_emplace(element.id.value);
    Entry &entry = found->second;
    entry.seen = mUpdate;
    if (entry.shape == element.shape)
        return &entry;
    if (isNew)
        entry.row = mTable.add();
    else
        giveRanges(entry);
    entry.range = entry.coarse = {};
    entry.shape = element.shape;
    entry.version = entry.shapeVersion = ++mVersion;
    entry.summary = {};
    if (const auto *mesh = std::get_if<MeshShape>(element.shape.get())) {
        entry.isMesh = true;
        entry.meanColour = meanColourOf(*mesh);
        for (const Vec3 &vertex : mesh->mesh.vertices)
            entry.summary.box.add(vertex);
        const std::vector<MeshVertex> vertices = verticesOf(*mesh, entry.row);
        const Result<CardRange> range = mTriangles.take(std::uint32_t(vertices.size() / 3));
        if (!range)
            return range.error();
        entry.range = *range;
        mTriangles.write(entry.range, vertices.data());
        return &entry;
    }
    entry.isMesh = false;
    if (Result<void> sent = sendStroke(std::get<StrokeShape>(*element.shape), entry); !sent)
        return sent.error();
    return &entry;
}

Result<void> PaintingUpload::sendStroke(const StrokeShape &stroke, Entry &entry)
{
    std::vector<SegmentData> segments;
    appendStrokeSegments(stroke, Eigen::Affine3d::Identity(), 0, std::nullopt, segments);
    entry.summary = summaryOf(segments);
    Result<CardRange> range = sendSegments(segments, entry.row, mSegments);
    if (!range)
        return range.error();
    entry.range = *range;

    const CoarseStroke coarse = coarseStroke(stroke);
    entry.coarseError = coarse.error;
    if (coarse.shape.points.size() * 2 > stroke.points.size())
        return {}; // not worth its room
    segments.clear();
    appendStrokeSegments(coarse.shape, Eigen::Affine3d::Identity(), 0, std::nullopt, segments);
    range = sendSegments(segments, entry.row, mCoarse);
    if (!range)
        return range.error();
    entry.coarse = *range;
    return {};
}

Result<CardRange> PaintingUpload::sendSegments(const std::vector<SegmentData> &segments, std::uint32_t row,
                                               CardArena &to)
{
    std::vector<SegmentInstance> instances;
    instances.reserve(segments.size());
    for (const SegmentData &segment : segments)
        instances.push_back(instanceOf(segment, row));
    Result<CardRange> range = to.take(std::uint32_t(instances.size()));
    if (range)
        to.write(*range, instances.data());
    return range;
}

void PaintingUpload::giveRanges(const Entry &entry)
{
    (entry.isMesh ? mTriangles : mSegments).give(entry.range);
    mCoarse.give(entry.coarse);
}

void PaintingUpload::dropUnseen(const Painting &painting)
{
    std::size_t seen = 0;
    for (const auto &[id, entry] : mEntries)
        seen += entry.seen == mUpdate;
    if (seen == mEntries.size())
        return;
    // Hidden layers and other frames of a drawing come back soon: only what the painting no longer has goes.
    for (const Layer *layer : painting.layers())
        for (const Drawing &drawing : layer->drawings)
            for (const Element &element : drawing.elements)
                if (const auto entry = mEntries.find(element.id.value); entry != mEntries.end())
                    entry->second.seen = mUpdate;
    for (auto entry = mEntries.begin(); entry != mEntries.end();) {
        if (entry->second.seen == mUpdate) {
            ++entry;
            continue;
        }
        giveRanges(entry->second);
        mTable.remove(entry->second.row);
        entry = mEntries.erase(entry);
    }
}

std::uint64_t PaintingUpload::signatureOf(const DrawnLayer &layer) const
{
    std::uint64_t hash = 14695981039346656037ull;
    for (const DrawnElement &element : layer.elements) {
        const auto entry = mEntries.find(mTable.at(element.row).element);
        hash = mixed(mixed(hash, std::uint64_t(entry->first)), entry->second.version);
    }
    return hash;
}

Result<void> PaintingUpload::updateReaches(const Painting &painting, const ElementPlacements &placements)
{
    std::map<LayerId, std::unique_ptr<LayerSolid>> substrates; // made when first needed
    const auto substrateOf = [&](const Stack &stack) {
        std::unique_ptr<LayerSolid> &solid = substrates[stack.substrate->id];
        if (!solid)
            solid = std::make_unique<LayerSolid>(*stack.substrate, stack.substrate->properties, placements);
        return solid.get();
    };
    std::map<StackId, std::uint64_t> signatures; // of visible substrates
    std::uint64_t all = 0;
    for (const DrawnStack &stack : mStacks)
        all = mixed(all, signatures[stack.id] = signatureOf(stack.substrate));

    const auto refresh = [&](const DrawnLayer &layer) -> Result<void> {
        if (!(layer.tolerance > 0) || layer.toleranceMode != ToleranceMode::Surface ||
            isSubstrate(painting, layer.id))
            return {};
        const auto own = signatures.find(layer.stack);
        std::uint64_t signature = mixed(signatureOf(layer), own == signatures.end() ? all : own->second);
        signature = mixed(signature, Eigen::numext::bit_cast<std::uint64_t>(layer.tolerance));
        std::uint64_t &known = mReachSignatures[layer.id];
        if (known == signature)
            return {};
        const Layer &source = *painting.findLayer(layer.id);
        LayerSolid solid(source, source.properties, placements);
        std::vector<const LayerSolid *> near;
        for (const DrawnStack &stack : mStacks)
            if (own == signatures.end() || stack.id == layer.stack)
                near.push_back(substrateOf(*painting.findStack(stack.id)));
        setReach(solid, near);
        known = signature;
        return writeReach(layer, solid);
    };
    for (const DrawnStack &stack : mStacks)
        for (const DrawnLayer &layer : stack.appearance)
            if (Result<void> done = refresh(layer); !done)
                return done;
    for (const DrawnLayer &layer : mSceneLayers)
        if (Result<void> done = refresh(layer); !done)
            return done;
    for (const auto &[id, layer] : mMaskLayers)
        if (Result<void> done = refresh(layer); !done)
            return done;
    return {};
}

Result<void> PaintingUpload::writeReach(const DrawnLayer &layer, const LayerSolid &solid)
{
    if (mReachCapacity < mSegments.capacity()) {
        GlBuffer larger = GlBuffer::create();
        glBindBuffer(GL_COPY_WRITE_BUFFER, larger.name());
        glBufferData(GL_COPY_WRITE_BUFFER, GLsizeiptr(mSegments.capacity()) * sizeof(ReachInstance), nullptr,
                     GL_DYNAMIC_DRAW);
        if (mReachCapacity > 0) {
            glBindBuffer(GL_COPY_READ_BUFFER, mReach.name());
            glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0,
                                GLsizeiptr(mReachCapacity) * sizeof(ReachInstance));
        }
        mReach = std::move(larger);
        mReachCapacity = mSegments.capacity();
        if (Result<void> room = checkGl("Uploading the painting"); !room)
            return room;
    }
    // The solid's segments lie in drawing order, as many a stroke as on the card.
    const std::vector<SegmentData> &segments = solid.segments();
    std::vector<ReachInstance> reaches;
    std::size_t at = 0;
    glBindBuffer(GL_COPY_WRITE_BUFFER, mReach.name());
    for (std::size_t i = 0; i < layer.elements.size(); ++i) {
        const DrawnElement &element = layer.elements[i];
        if (element.isMesh)
            continue;
        for (std::uint32_t k = 0; k < element.range.count; ++k)
            reaches.push_back(reachOf(segments[at++]));
        const bool isLast = i + 1 == layer.elements.size();
        const bool goesOn = !isLast && !layer.elements[i + 1].isMesh &&
                            layer.elements[i + 1].range.first == element.range.first + element.range.count;
        if (goesOn)
            continue;
        const std::size_t first = element.range.first + element.range.count - reaches.size();
        glBufferSubData(GL_COPY_WRITE_BUFFER, GLintptr(first * sizeof(ReachInstance)),
                        GLsizeiptr(reaches.size() * sizeof(ReachInstance)), reaches.data());
        mReachBytes += reaches.size() * sizeof(ReachInstance);
        reaches.clear();
    }
    DUCTUS_ASSERT(at == segments.size());
    return {};
}

Result<void> PaintingUpload::prepareRibbons()
{
    if (mRibbonsUpdate == mUpdate)
        return {};
    std::vector<const DrawnLayer *> substrates;
    for (const DrawnStack &stack : mStacks) {
        substrates.push_back(&stack.substrate);
        if (Result<void> done = mRibbons.update(stack.substrate); !done)
            return done;
    }
    mRibbons.keepOnly(substrates);
    mRibbonsUpdate = mUpdate;
    return checkGl("Uploading the painting");
}

UploadedBytes PaintingUpload::uploaded() const
{
    return {mSegments.bytesWritten() + mCoarse.bytesWritten() + mTriangles.bytesWritten(),
            mTable.bytesWritten(), mReachBytes};
}

} // namespace ductus
