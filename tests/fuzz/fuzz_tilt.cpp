#include "check_readers.h"

#include <cstdint>

/// The data.sketch of a .tilt.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    ductus::checkTiltReader({reinterpret_cast<const char *>(data), size});
    return 0;
}
