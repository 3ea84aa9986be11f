// Members of a JSON object by name, with the first wrong one remembered: readers ask for all they want and
// look for the error once.
#pragma once

#include "base/error.h"

#include <Eigen/Core>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace ductus {

class ObjectFields
{
public:
    /// \a fault, if free, receives "Opacity is no number"; object and fault must outlive this.
    ObjectFields(const nlohmann::json &object, std::optional<std::string> &fault)
        : mObject(object), mFault(fault)
    {
    }

    /// Null if it is missing.
    const nlohmann::json *find(const char *key) const;

    // Missing members give the fallback; members of the wrong kind too, and are a fault.
    double number(const char *key, double fallback) const;
    bool boolean(const char *key, bool fallback) const;
    std::string text(const char *key, const std::string &fallback) const;
    /// A number, or a text with one: Quill writes times as texts.
    double numberOrText(const char *key, double fallback) const;
    int integerOrText(const char *key, int fallback) const;
    /// Exactly as many numbers as \a values has; untouched if missing.
    void numbers(const char *key, double *values, std::size_t count) const;
    /// Null if missing; a fault if it is no array or no object.
    const nlohmann::json *array(const char *key) const;
    const nlohmann::json *object(const char *key) const;

    void fault(std::string problem) const;

private:
    const nlohmann::json &mObject;
    std::optional<std::string> &mFault;
};

/// A number, or a text that is one from end to end and finite.
std::optional<double> numberIn(const nlohmann::json &value);

} // namespace ductus
