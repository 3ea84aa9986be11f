// Typed ids: a StrokeId is not a LayerId and neither is an int.
//
//     using StrokeId = TypedId<struct StrokeIdTag>;
#pragma once

#include <compare>
#include <cstdint>
#include <functional>

namespace ductus {

template <typename Tag>
struct TypedId
{
    std::int32_t value = -1;

    bool isValid() const { return value >= 0; }
    auto operator<=>(const TypedId &) const = default;
};

} // namespace ductus

template <typename Tag>
struct std::hash<ductus::TypedId<Tag>>
{
    std::size_t operator()(const ductus::TypedId<Tag> &id) const noexcept
    {
        return std::hash<std::int32_t>()(id.value);
    }
};
