// JsonReader: a cursor on a JSON value that checks every field it is asked for. The first thing wrong is
// remembered with its path ("hat.ductus:documents/<uuid>.json#/strokes/3/points/shape"); later calls return
// defaults, so a decoder reads straight through and asks once at the end.
//
//     const double scale = reader.number("metresPerUnit", 0.0, 1e9);
//     const StrokeRole role = reader.oneOf("role", roleNames);
//     if (reader.failed())
//         return reader.error();
#pragma once

#include "base/result.h"
#include "project/json/json_document.h"
#include "project/json/raw_json.h"

#include <array>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>

namespace ductus {

class JsonReader
{
public:
    /// \a document must outlive the reader and all it hands out.
    JsonReader(const JsonDocument &document, std::string place);

    bool failed() const { return mShared->error.has_value(); }
    const Error &error() const { return *mShared->error; }
    /// Where this value stands.
    std::string path() const { return mPath; }
    /// Remembers \a problem at this value unless something was wrong before.
    void fail(std::string problem, ErrorCode code = ErrorCode::Malformed) const;
    /// The same for its member \a key.
    void failAt(std::string_view key, std::string problem, ErrorCode code = ErrorCode::Malformed) const;

    /// False also for values that are no objects.
    bool has(std::string_view key) const;
    bool isObject() const { return mValue->is_object(); }

    /// Fails unless this is an object without repeated names.
    void expectObject() const;

    JsonReader member(std::string_view key) const;
    /// Fails if there are more than \a maxCount.
    std::vector<JsonReader> elements(std::string_view key, std::size_t maxCount) const;

    std::string string(std::string_view key, std::size_t maxLength) const;
    std::int64_t integer(std::string_view key, std::int64_t min, std::int64_t max) const;
    std::uint64_t unsignedInteger(std::string_view key) const;
    double number(std::string_view key, double min, double max) const;
    bool boolean(std::string_view key) const;
    std::array<double, 3> triple(std::string_view key) const;
    /// Exactly \a count finite numbers.
    std::vector<double> numbers(std::string_view key, std::size_t count) const;
    /// At most \a maxCount arrays of \a width finite numbers.
    std::vector<std::vector<double>> rows(std::string_view key, std::size_t maxCount,
                                          std::size_t width) const;
    std::vector<std::uint64_t> unsignedIntegers(std::string_view key, std::size_t maxCount) const;

    /// The value whose name stands there; \a names pairs of name and value.
    template <typename T>
    T oneOf(std::string_view key, std::span<const std::pair<std::string_view, T>> names) const
    {
        const std::string text = string(key, 64);
        for (const auto &[name, value] : names) {
            if (name == text)
                return value;
        }
        failAt(key, "\"" + text + "\" is not one of the known words");
        return names.front().second;
    }

    /// The members that are not among \a known, as text.
    UnknownMembers unknown(std::initializer_list<std::string_view> known) const;

private:
    struct Shared
    {
        std::optional<Error> error;
    };

    JsonReader(const nlohmann::json *value, std::string_view text, std::string path,
               std::shared_ptr<Shared> shared);
    const nlohmann::json *find(std::string_view key) const;

    const nlohmann::json *mValue;
    std::string_view mText;
    std::string mPath;
    std::shared_ptr<Shared> mShared;
};

} // namespace ductus
