#include "check_readers.h"

#include <cstdint>

/// Meshes of one format: the build says which (DUCTUS_FUZZ_NAME, "f.glb").
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const std::string_view bytes(reinterpret_cast<const char *>(data), size);
    ductus::checkMeshReader(bytes, DUCTUS_FUZZ_NAME);
    if (bytes.starts_with("glTF"))
        ductus::checkColouredMeshReader(bytes, DUCTUS_FUZZ_NAME);
    return 0;
}
