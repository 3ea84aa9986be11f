#include "base/error.h"

namespace ductus {

std::string Error::message() const
{
    if (isCancelled())
        return attempted.empty() ? "Cancelled." : attempted + " was cancelled.";
    std::string text;
    if (!place.empty())
        text += place + ": ";
    if (!attempted.empty())
        text += attempted + " failed: ";
    text += problem + ".";
    if (!remedy.empty())
        text += " " + remedy + ".";
    return text;
}

std::string_view errorCodeName(ErrorCode code)
{
    switch (code) {
    case ErrorCode::Cancelled: return "cancelled";
    case ErrorCode::FileNotFound: return "file-not-found";
    case ErrorCode::PermissionDenied: return "permission-denied";
    case ErrorCode::NotAFile: return "not-a-file";
    case ErrorCode::ReadFailed: return "read-failed";
    case ErrorCode::WriteFailed: return "write-failed";
    case ErrorCode::Malformed: return "malformed";
    case ErrorCode::Unsupported: return "unsupported";
    case ErrorCode::TooLarge: return "too-large";
    case ErrorCode::TooLittleData: return "too-little-data";
    case ErrorCode::InvalidArgument: return "invalid-argument";
    case ErrorCode::NoSolution: return "no-solution";
    case ErrorCode::NewerVersion: return "newer-version";
    case ErrorCode::Locked: return "locked";
    }
    return "unknown";
}

Error cancelledError(std::string attempted)
{
    return {ErrorCode::Cancelled, std::move(attempted), "cancelled", "", ""};
}

} // namespace ductus
