// The words and bounds of sketch-surface documents, shared by writer and reader.
#pragma once

#include "strokes/stroke.h"

#include <limits>
#include <string_view>
#include <utility>

namespace ductus {

inline constexpr std::pair<std::string_view, StrokeRole> strokeRoleNames[] = {
    {"surface", StrokeRole::Surface}, {"boundary", StrokeRole::Boundary}, {"ignored", StrokeRole::Ignored},
    {"inner", StrokeRole::Inner},     {"skeletal", StrokeRole::Skeletal},
};

inline constexpr std::pair<std::string_view, UpAxis> upAxisNames[] = {{"y", UpAxis::Y}, {"z", UpAxis::Z}};

inline constexpr std::size_t maxStoredStrokes = 1'000'000;
inline constexpr std::size_t maxStoredModels = 100'000;
inline constexpr int maxReadingDegree = 4;
/// How many monomials of up to \a degree three variables have.
constexpr std::size_t readingCoefficients(int degree)
{
    return std::size_t((degree + 1) * (degree + 2) * (degree + 3) / 6);
}
inline constexpr int maxRegion = std::numeric_limits<int>::max(); // exclusive

} // namespace ductus
