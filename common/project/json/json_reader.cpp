#include "project/json/json_reader.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace ductus {

namespace {

const nlohmann::json nullValue;

// A key as it stands in the text, without quotes; escapes undone only where there are any.
std::string plainKey(std::string_view raw)
{
    if (raw.find('\\') == std::string_view::npos)
        return std::string(raw.substr(1, raw.size() - 2));
    return nlohmann::json::parse(raw).get<std::string>(); // was parsed once already, so this cannot fail
}

std::string rangeText(double min, double max)
{
    return nlohmann::json(min).dump() + " to " + nlohmann::json(max).dump();
}

std::string kindProblem(std::string_view expected)
{
    return std::string(expected) + " is expected here";
}

} // namespace

JsonReader::JsonReader(const JsonDocument &document, std::string place)
    : JsonReader(&document.value, document.text, std::move(place) + "#", std::make_shared<Shared>())
{
}

JsonReader::JsonReader(const nlohmann::json *value, std::string_view text, std::string path,
                       std::shared_ptr<Shared> shared)
    : mValue(value), mText(text), mPath(std::move(path)), mShared(std::move(shared))
{
}

void JsonReader::fail(std::string problem, ErrorCode code) const
{
    if (!mShared->error)
        mShared->error = Error{code, "Reading the project", std::move(problem), "", mPath};
}

void JsonReader::failAt(std::string_view key, std::string problem, ErrorCode code) const
{
    if (!mShared->error)
        mShared->error =
            Error{code, "Reading the project", std::move(problem), "", mPath + "/" + std::string(key)};
}

bool JsonReader::has(std::string_view key) const
{
    return mValue->is_object() && mValue->contains(key);
}

void JsonReader::expectObject() const
{
    if (!mValue->is_object())
        return fail(kindProblem("an object"));
    if (rawMembers(mText).size() != mValue->size())
        fail("a name occurs twice in this object");
}

const nlohmann::json *JsonReader::find(std::string_view key) const
{
    if (mValue->is_object()) {
        if (const auto found = mValue->find(key); found != mValue->end())
            return &*found;
    }
    failAt(key, "this field is missing");
    return &nullValue;
}

JsonReader JsonReader::member(std::string_view key) const
{
    const nlohmann::json *value = find(key);
    std::string_view text = "null";
    for (const RawMember &raw : rawMembers(mText)) {
        if (plainKey(raw.key) == key)
            text = raw.value;
    }
    JsonReader reader(value, text, mPath + "/" + std::string(key), mShared);
    if (!failed())
        reader.expectObject();
    return reader;
}

std::vector<JsonReader> JsonReader::elements(std::string_view key, std::size_t maxCount) const
{
    const nlohmann::json *value = find(key);
    if (failed())
        return {};
    if (!value->is_array() || value->size() > maxCount) {
        failAt(key, value->is_array() ? "there are too many elements" : kindProblem("an array"));
        return {};
    }
    std::vector<JsonReader> readers;
    for (const RawMember &raw : rawMembers(mText)) {
        if (plainKey(raw.key) != key)
            continue;
        const std::vector<std::string_view> texts = rawElements(raw.value);
        DUCTUS_ASSERT(texts.size() == value->size());
        for (std::size_t i = 0; i < texts.size(); ++i) {
            readers.push_back(JsonReader(&(*value)[i], texts[i],
                                         mPath + "/" + std::string(key) + "/" + std::to_string(i), mShared));
            readers.back().expectObject();
        }
        break;
    }
    return readers;
}

std::string JsonReader::string(std::string_view key, std::size_t maxLength) const
{
    const nlohmann::json *value = find(key);
    if (!value->is_string()) {
        failAt(key, kindProblem("a text"));
        return {};
    }
    const auto &text = value->get_ref<const std::string &>();
    if (text.size() > maxLength) {
        failAt(key, "the text is too long");
        return {};
    }
    return text;
}

std::int64_t JsonReader::integer(std::string_view key, std::int64_t min, std::int64_t max) const
{
    const nlohmann::json *value = find(key);
    const bool fits = value->is_number_integer() && (!value->is_number_unsigned() ||
                                                     value->get<std::uint64_t>() <= std::uint64_t(INT64_MAX));
    const std::int64_t number = fits ? value->get<std::int64_t>() : min;
    if (!fits || number < min || number > max)
        failAt(key, kindProblem("a whole number from " + std::to_string(min) + " to " + std::to_string(max)));
    return std::clamp(number, min, max);
}

std::uint64_t JsonReader::unsignedInteger(std::string_view key) const
{
    const nlohmann::json *value = find(key);
    if (value->is_number_unsigned())
        return value->get<std::uint64_t>();
    failAt(key, kindProblem("a whole number that is not negative"));
    return 0;
}

double JsonReader::number(std::string_view key, double min, double max) const
{
    const nlohmann::json *value = find(key);
    const double number = value->is_number() ? value->get<double>() : std::nan("");
    if (number >= min && number <= max)
        return number;
    failAt(key, kindProblem("a number from " + rangeText(min, max)));
    return min;
}

bool JsonReader::boolean(std::string_view key) const
{
    const nlohmann::json *value = find(key);
    if (value->is_boolean())
        return value->get<bool>();
    failAt(key, kindProblem("true or false"));
    return false;
}

std::array<double, 3> JsonReader::triple(std::string_view key) const
{
    const std::vector<double> values = numbers(key, 3);
    return {values[0], values[1], values[2]};
}

std::vector<double> JsonReader::numbers(std::string_view key, std::size_t count) const
{
    const nlohmann::json *value = find(key);
    const auto isFinite = [](const nlohmann::json &v) {
        return v.is_number() && std::isfinite(v.get<double>());
    };
    if (value->is_array() && value->size() == count && std::all_of(value->begin(), value->end(), isFinite))
        return value->get<std::vector<double>>();
    failAt(key, kindProblem("an array of " + std::to_string(count) + " numbers"));
    return std::vector<double>(count, 0.0);
}

std::vector<std::vector<double>> JsonReader::rows(std::string_view key, std::size_t maxCount,
                                                  std::size_t width) const
{
    const nlohmann::json *value = find(key);
    const auto isFinite = [](const nlohmann::json &v) {
        return v.is_number() && std::isfinite(v.get<double>());
    };
    const auto isRow = [&](const nlohmann::json &row) {
        return row.is_array() && row.size() == width && std::all_of(row.begin(), row.end(), isFinite);
    };
    if (value->is_array() && value->size() <= maxCount && std::all_of(value->begin(), value->end(), isRow))
        return value->get<std::vector<std::vector<double>>>();
    failAt(key, kindProblem("an array of rows of " + std::to_string(width) + " numbers"));
    return {};
}

std::vector<std::uint64_t> JsonReader::unsignedIntegers(std::string_view key, std::size_t maxCount) const
{
    const nlohmann::json *value = find(key);
    const auto isUnsigned = [](const nlohmann::json &v) { return v.is_number_unsigned(); };
    if (value->is_array() && value->size() <= maxCount &&
        std::all_of(value->begin(), value->end(), isUnsigned))
        return value->get<std::vector<std::uint64_t>>();
    failAt(key, kindProblem("an array of at most " + std::to_string(maxCount) + " whole numbers"));
    return {};
}

UnknownMembers JsonReader::unknown(std::initializer_list<std::string_view> known) const
{
    UnknownMembers members;
    for (const RawMember &raw : rawMembers(mText)) {
        const std::string key = plainKey(raw.key);
        if (std::find(known.begin(), known.end(), key) == known.end())
            members.emplace_back(key, raw.value);
    }
    return members;
}

} // namespace ductus
