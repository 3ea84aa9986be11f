#include "check_readers.h"
#include "support/quill_sample.h"

#include <cstdint>

/// Quill.qbin below an undamaged Quill.json: nothing is lost to JSON that does not parse.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const std::string json = ductus::quillSample().json + '\0';
    ductus::checkQuillReader(json + std::string(reinterpret_cast<const char *>(data), size));
    return 0;
}
