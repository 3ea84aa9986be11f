#include "painting_project.h"

#include <cstdint>

/// The text of a painting's document.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    ductus::checkPaintingReader({reinterpret_cast<const char *>(data), size});
    return 0;
}
