#include "formats/paintings/object_fields.h"

#include "formats/text/number_text.h"

#include <cmath>

namespace ductus {

using Json = nlohmann::json;

std::optional<double> numberIn(const Json &value)
{
    if (value.is_number())
        return value.get<double>();
    double number = 0;
    if (value.is_string() && readNumber(value.get_ref<const std::string &>(), number) == NumberFault::None)
        return number;
    return std::nullopt;
}

const Json *ObjectFields::find(const char *key) const
{
    const auto found = mObject.find(key);
    return found == mObject.end() ? nullptr : &*found;
}

void ObjectFields::fault(std::string problem) const
{
    if (!mFault)
        mFault = std::move(problem);
}

double ObjectFields::number(const char *key, double fallback) const
{
    const Json *value = find(key);
    if (value && !value->is_number())
        fault(std::string(key) + " is no number");
    return value && value->is_number() ? value->get<double>() : fallback;
}

bool ObjectFields::boolean(const char *key, bool fallback) const
{
    const Json *value = find(key);
    if (value && !value->is_boolean())
        fault(std::string(key) + " is neither true nor false");
    return value && value->is_boolean() ? value->get<bool>() : fallback;
}

std::string ObjectFields::text(const char *key, const std::string &fallback) const
{
    const Json *value = find(key);
    if (value && !value->is_string())
        fault(std::string(key) + " is no text");
    return value && value->is_string() ? value->get<std::string>() : fallback;
}

double ObjectFields::numberOrText(const char *key, double fallback) const
{
    const Json *value = find(key);
    if (!value)
        return fallback;
    const std::optional<double> number = numberIn(*value);
    if (!number)
        fault(std::string(key) + " is no number");
    return number.value_or(fallback);
}

int ObjectFields::integerOrText(const char *key, int fallback) const
{
    const double value = numberOrText(key, fallback);
    if (std::abs(value) > 2e9 || value != std::floor(value)) {
        fault(std::string(key) + " is no whole number of usual size");
        return fallback;
    }
    return int(value);
}

void ObjectFields::numbers(const char *key, double *values, std::size_t count) const
{
    const Json *list = array(key);
    if (!list)
        return;
    bool ok = list->size() == count;
    for (const Json &item : *list)
        ok = ok && item.is_number();
    if (!ok) {
        fault(std::string(key) + " is no list of " + std::to_string(count) + " numbers");
        return;
    }
    for (std::size_t i = 0; i < count; ++i)
        values[i] = (*list)[i].get<double>();
}

const Json *ObjectFields::array(const char *key) const
{
    const Json *value = find(key);
    if (value && !value->is_array()) {
        fault(std::string(key) + " is no list");
        return nullptr;
    }
    return value;
}

const Json *ObjectFields::object(const char *key) const
{
    const Json *value = find(key);
    if (value && !value->is_object()) {
        fault(std::string(key) + " is no object");
        return nullptr;
    }
    return value;
}

} // namespace ductus
