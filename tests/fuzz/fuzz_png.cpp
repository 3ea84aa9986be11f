#include "check_readers.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const std::string_view bytes(reinterpret_cast<const char *>(data), size);
    ductus::checkPngReader(bytes);
    ductus::checkPngReader(ductus::withRightChecksums(bytes));
    return 0;
}
