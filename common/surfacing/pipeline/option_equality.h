// Equality of option structs, field by field, without a list of their fields: an option added to a stage
// tomorrow is compared as well, where a list by hand would silently keep a stale result. For plain aggregates
// of up to twenty fields; nested ones are compared the same way.
#pragma once

#include <concepts>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace ductus {

namespace option_equality_detail {

struct AnyField
{
    template <typename T>
    operator T() const; // only ever named, never called
};

template <typename T, typename... Fields>
constexpr std::size_t fieldCount()
{
    if constexpr (requires { T{Fields{}..., AnyField{}}; })
        return fieldCount<T, Fields..., AnyField>();
    else
        return sizeof...(Fields);
}

/// References to all fields.
template <typename T>
auto fieldsOf(const T &o)
{
    constexpr std::size_t n = fieldCount<T>();
    static_assert(n >= 1 && n <= 20, "options have 1 to 20 fields");
    if constexpr (n == 1) {
        const auto &[f0] = o;
        return std::tie(f0);
    } else if constexpr (n == 2) {
        const auto &[f0, f1] = o;
        return std::tie(f0, f1);
    } else if constexpr (n == 3) {
        const auto &[f0, f1, f2] = o;
        return std::tie(f0, f1, f2);
    } else if constexpr (n == 4) {
        const auto &[f0, f1, f2, f3] = o;
        return std::tie(f0, f1, f2, f3);
    } else if constexpr (n == 5) {
        const auto &[f0, f1, f2, f3, f4] = o;
        return std::tie(f0, f1, f2, f3, f4);
    } else if constexpr (n == 6) {
        const auto &[f0, f1, f2, f3, f4, f5] = o;
        return std::tie(f0, f1, f2, f3, f4, f5);
    } else if constexpr (n == 7) {
        const auto &[f0, f1, f2, f3, f4, f5, f6] = o;
        return std::tie(f0, f1, f2, f3, f4, f5, f6);
    } else if constexpr (n == 8) {
        const auto &[f0, f1, f2, f3, f4, f5, f6, f7] = o;
        return std::tie(f0, f1, f2, f3, f4, f5, f6, f7);
    } else if constexpr (n == 9) {
        const auto &[f0, f1, f2, f3, f4, f5, f6, f7, f8] = o;
        return std::tie(f0, f1, f2, f3, f4, f5, f6, f7, f8);
    } else if constexpr (n == 10) {
        const auto &[f0, f1, f2, f3, f4, f5, f6, f7, f8, f9] = o;
        return std::tie(f0, f1, f2, f3, f4, f5, f6, f7, f8, f9);
    } else if constexpr (n == 11) {
        const auto &[f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10] = o;
        return std::tie(f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10);
    } else if constexpr (n == 12) {
        const auto &[f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11] = o;
        return std::tie(f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11);
    } else if constexpr (n == 13) {
        const auto &[f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12] = o;
        return std::tie(f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12);
    } else if constexpr (n == 14) {
        const auto &[f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13] = o;
        return std::tie(f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13);
    } else if constexpr (n == 15) {
        const auto &[f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14] = o;
        return std::tie(f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14);
    } else if constexpr (n == 16) {
        const auto &[f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15] = o;
        return std::tie(f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15);
    } else if constexpr (n == 17) {
        const auto &[f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16] = o;
        return std::tie(f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16);
    } else if constexpr (n == 18) {
        const auto &[f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17] = o;
        return std::tie(f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17);
    } else if constexpr (n == 19) {
        const auto &[f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18] = o;
        return std::tie(f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18);
    } else if constexpr (n == 20) {
        const auto &[f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18,
                     f19] = o;
        return std::tie(f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18,
                        f19);
    }
}

} // namespace option_equality_detail

template <typename T>
bool sameOptions(const T &a, const T &b)
{
    if constexpr (std::equality_comparable<T>) {
        return a == b;
    } else {
        namespace detail = option_equality_detail;
        const auto fieldsA = detail::fieldsOf(a);
        const auto fieldsB = detail::fieldsOf(b);
        return [&]<std::size_t... I>(std::index_sequence<I...>)
        {
            return (sameOptions(std::get<I>(fieldsA), std::get<I>(fieldsB)) && ...);
        }
        (std::make_index_sequence<std::tuple_size_v<decltype(fieldsA)>>());
    }
}

} // namespace ductus
