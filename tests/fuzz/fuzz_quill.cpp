#include "check_readers.h"

#include <cstdint>

/// Quill.json, a zero byte, Quill.qbin.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    ductus::checkQuillReader({reinterpret_cast<const char *>(data), size});
    return 0;
}
