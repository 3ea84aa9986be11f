// Result<T>: a value, or the Error that says why there is none. Result<void> for functions without a value.
#pragma once

#include "base/assert.h"
#include "base/error.h"

#include <optional>
#include <utility>
#include <variant>

namespace ductus {

template <typename T>
class [[nodiscard]] Result
{
public:
    Result(T value) : mContent(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : mContent(std::in_place_index<1>, std::move(error)) {}

    bool ok() const { return mContent.index() == 0; }
    explicit operator bool() const { return ok(); }

    const T &value() const &
    {
        DUCTUS_ASSERT(ok());
        return std::get<0>(mContent);
    }
    T &value() &
    {
        DUCTUS_ASSERT(ok());
        return std::get<0>(mContent);
    }
    T &&value() &&
    {
        DUCTUS_ASSERT(ok());
        return std::get<0>(std::move(mContent));
    }
    const T &operator*() const & { return value(); }
    T &operator*() & { return value(); }
    T &&operator*() && { return std::move(*this).value(); }
    const T *operator->() const { return &value(); }
    T *operator->() { return &value(); }

    const Error &error() const
    {
        DUCTUS_ASSERT(!ok());
        return std::get<1>(mContent);
    }

private:
    std::variant<T, Error> mContent;
};

template <>
class [[nodiscard]] Result<void>
{
public:
    Result() = default;
    Result(Error error) : mError(std::move(error)) {}

    bool ok() const { return !mError.has_value(); }
    explicit operator bool() const { return ok(); }
    const Error &error() const
    {
        DUCTUS_ASSERT(!ok());
        return *mError;
    }

private:
    std::optional<Error> mError;
};

} // namespace ductus
