// What a failure says to the user: what was attempted, what went wrong, what to do, and where.
// Every engine function that can fail on input returns Result<T> (result.h); exceptions are left to bugs.
#pragma once

#include <string>
#include <string_view>

namespace ductus {

enum class ErrorCode {
    Cancelled,
    FileNotFound,
    PermissionDenied,
    NotAFile,
    ReadFailed,
    WriteFailed,
    Malformed,
    Unsupported,
    TooLarge,
    TooLittleData,
    InvalidArgument,
    NoSolution,
    NewerVersion,
    Locked,
};

struct Error
{
    ErrorCode code = ErrorCode::Malformed;
    std::string attempted; // "Reading the sketch"
    std::string problem;   // "the x coordinate is not a number"
    std::string remedy;    // "Export the sketch again"; may be empty
    std::string place;     // "hat.curves:12", an entry of a container, or empty

    /// One line for people: "hat.curves:12: Reading the sketch failed: <problem>. <remedy>."
    std::string message() const;

    bool isCancelled() const { return code == ErrorCode::Cancelled; }
};

/// Stable lower-case name of a code, for JSON reports.
std::string_view errorCodeName(ErrorCode code);

/// The error every cancelled job ends with.
Error cancelledError(std::string attempted);

} // namespace ductus
