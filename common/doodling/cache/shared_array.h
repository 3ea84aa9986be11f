// SharedArray: numbers that never change, owned together by all copies. They lie in memory or in a mapped
// file, and whoever reads them need not know which.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace ductus {

template <typename T>
class SharedArray
{
public:
    SharedArray() = default;
    SharedArray(std::vector<T> values)
    {
        auto owned = std::make_shared<const std::vector<T>>(std::move(values));
        mValues = *owned;
        mOwner = std::move(owned);
    }
    /// \a owner keeps what \a values lie in.
    SharedArray(std::span<const T> values, std::shared_ptr<const void> owner)
        : mValues(values), mOwner(std::move(owner))
    {
    }

    std::size_t size() const { return mValues.size(); }
    bool empty() const { return mValues.empty(); }
    const T &operator[](std::size_t i) const { return mValues[i]; }
    const T *data() const { return mValues.data(); }
    auto begin() const { return mValues.begin(); }
    auto end() const { return mValues.end(); }
    operator std::span<const T>() const { return mValues; }

    bool operator==(const SharedArray &other) const
    {
        return std::equal(begin(), end(), other.begin(), other.end());
    }

private:
    std::span<const T> mValues;
    std::shared_ptr<const void> mOwner;
};

} // namespace ductus
