// What the OpenXR loader hands to a runtime and takes from it. Debian's libopenxr-dev has no header for it;
// the field order is the specification's, the sizes are checked here.
#pragma once

#include <openxr/openxr.h>

#include <cstddef>
#include <cstdint>

namespace ductus::xr {

struct LoaderInfo
{
    std::uint32_t structType; // loaderInfoType
    std::uint32_t structVersion;
    std::size_t structSize;
    std::uint32_t minInterfaceVersion, maxInterfaceVersion;
    XrVersion minApiVersion, maxApiVersion;
};

struct RuntimeRequest
{
    std::uint32_t structType; // runtimeRequestType
    std::uint32_t structVersion;
    std::size_t structSize;
    std::uint32_t runtimeInterfaceVersion; // ours to write, as what follows
    XrVersion runtimeApiVersion;
    PFN_xrGetInstanceProcAddr getInstanceProcAddr;
};

inline constexpr std::uint32_t loaderInfoType = 1, runtimeRequestType = 3;
inline constexpr std::uint32_t interfaceVersion = 1;

static_assert(sizeof(LoaderInfo) == 40 && sizeof(RuntimeRequest) == 40);

} // namespace ductus::xr

extern "C" __attribute__((visibility("default"))) XrResult
xrNegotiateLoaderRuntimeInterface(const ductus::xr::LoaderInfo *loader, ductus::xr::RuntimeRequest *runtime);
