#include "surfacing/refinement/scribble.h"

#include <array>
#include <utility>

namespace ductus {

namespace {

constexpr std::array<std::pair<ScribbleKind, std::string_view>, 7> names{{
    {ScribbleKind::NewRegion, "new-region"},
    {ScribbleKind::Merge, "merge"},
    {ScribbleKind::Seam, "seam"},
    {ScribbleKind::ForbidSeam, "forbid-seam"},
    {ScribbleKind::Split, "split"},
    {ScribbleKind::Lock, "lock"},
    {ScribbleKind::SetDegree, "set-degree"},
}};

} // namespace

std::string_view scribbleKindName(ScribbleKind kind)
{
    for (const auto &[known, name] : names)
        if (known == kind)
            return name;
    return "unknown";
}

std::optional<ScribbleKind> scribbleKindFromName(std::string_view name)
{
    for (const auto &[kind, known] : names)
        if (known == name)
            return kind;
    return std::nullopt;
}

} // namespace ductus
