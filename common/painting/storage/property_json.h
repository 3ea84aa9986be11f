// The JSON of what a layer has besides its strokes: properties, masks, keys, placements. The same in the
// project file and in the action log; they differ in how the bytes of a texture mask are written.
#pragma once

#include "painting/storage/painting_content.h"

#include <functional>

namespace ductus {

OrderedJson tripleJson(const Vec3 &v);
OrderedJson tripleJson(const Eigen::Vector3f &v);
OrderedJson rotationJson(const Eigen::Quaterniond &q); // x, y, z, w
OrderedJson placementJson(const Placement &placement);

Vec3 readTriple(const JsonReader &reader, std::string_view key);
Eigen::Quaterniond readRotation(const JsonReader &reader);
Placement readPlacementOf(const JsonReader &reader);
/// The member "placement" of \a owner.
Placement readPlacement(const JsonReader &owner);

class PropertyJsonWriter
{
public:
    using Bytes = std::function<OrderedJson(const std::vector<std::uint8_t> &)>;

    /// \a unknown (may be null) must outlive the writer.
    PropertyJsonWriter(const UnknownPaintingMembers *unknown, Bytes bytes)
        : mUnknown(unknown), mBytes(std::move(bytes))
    {
    }

    OrderedJson properties(const LayerProperties &properties, const std::string &place) const;
    OrderedJson mask(const Mask &mask) const;
    OrderedJson keys(const std::vector<PlacementKey> &keys, const std::string &place) const;
    /// \a object with what is not known of it.
    OrderedJson kept(OrderedJson object, const std::string &place) const;

private:
    OrderedJson shapeJson(const GradientMask &mask) const;
    OrderedJson shapeJson(const NoiseMask &mask) const;
    OrderedJson shapeJson(const TextureMask &mask) const;
    OrderedJson shapeJson(const StrokeMask &mask) const;

    const UnknownPaintingMembers *mUnknown;
    Bytes mBytes;
};

/// What is wrong is told through the readers handed in.
class PropertyJsonReader
{
public:
    using Bytes = std::function<std::vector<std::uint8_t>(const JsonReader &owner, std::string_view key)>;

    /// \a unknown (may be null) must outlive the reader.
    PropertyJsonReader(UnknownPaintingMembers *unknown, Bytes bytes)
        : mUnknown(unknown), mBytes(std::move(bytes))
    {
    }

    LayerProperties properties(const JsonReader &reader, const std::string &place) const;
    Mask mask(const JsonReader &reader, const std::string &place) const;
    std::vector<PlacementKey> keys(const JsonReader &owner, std::string_view key,
                                   const std::string &place) const;
    /// Keeps the members of \a object that are not \a known.
    void keep(const JsonReader &object, const std::string &place,
              std::initializer_list<std::string_view> known) const;

private:
    TextureMask texture(const JsonReader &reader) const;

    UnknownPaintingMembers *mUnknown;
    Bytes mBytes;
};

} // namespace ductus
