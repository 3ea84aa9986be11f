// The words of painting documents, shared by writer and reader.
#pragma once

#include "base/assert.h"
#include "painting/scene/painting.h"

#include <array>
#include <string_view>
#include <utility>

namespace ductus {

template <typename T>
using PaintingWords = std::pair<std::string_view, T>;

inline constexpr PaintingWords<BlendSpace> blendSpaceNames[] = {{"encoded", BlendSpace::Encoded},
                                                                {"linear", BlendSpace::Linear}};
inline constexpr PaintingWords<ToleranceMode> toleranceModeNames[] = {{"surface", ToleranceMode::Surface},
                                                                      {"view", ToleranceMode::View}};
inline constexpr PaintingWords<KeyInterpolation> interpolationNames[] = {
    {"hold", KeyInterpolation::Hold},
    {"linear", KeyInterpolation::Linear},
    {"smooth", KeyInterpolation::Smooth}};
inline constexpr PaintingWords<MaskEasing> easingNames[] = {{"linear", MaskEasing::Linear},
                                                            {"smooth", MaskEasing::Smooth}};
inline constexpr PaintingWords<GradientMask::Shape> gradientNames[] = {
    {"linear", GradientMask::Shape::Linear}, {"spherical", GradientMask::Shape::Spherical}};

enum class MaskKind { Gradient, Noise, Texture, Strokes }; // in the order of Mask::shape
inline constexpr PaintingWords<MaskKind> maskKindNames[] = {{"gradient", MaskKind::Gradient},
                                                            {"noise", MaskKind::Noise},
                                                            {"texture", MaskKind::Texture},
                                                            {"strokes", MaskKind::Strokes}};

enum class BlockKind { Strokes, Mesh };
inline constexpr PaintingWords<BlockKind> blockKindNames[] = {{"strokes", BlockKind::Strokes},
                                                              {"mesh", BlockKind::Mesh}};

// By value, as Quill counts them; the numbers of the column "sections".
inline constexpr std::array storedSections = {StrokeSection::Round, StrokeSection::Ellipse,
                                              StrokeSection::Cube, StrokeSection::Ribbon};

inline std::array<PaintingWords<BlendMode>, blendModeCount> blendModeNames()
{
    std::array<PaintingWords<BlendMode>, blendModeCount> names;
    for (int i = 0; i < blendModeCount; ++i)
        names[std::size_t(i)] = {blendModeName(BlendMode(i)), BlendMode(i)};
    return names;
}

template <typename T, std::size_t n>
std::string_view wordOf(const PaintingWords<T> (&names)[n], T value)
{
    for (const auto &[name, named] : names) {
        if (named == value)
            return name;
    }
    DUCTUS_ASSERT(!"every value has a word");
    return {};
}

} // namespace ductus
