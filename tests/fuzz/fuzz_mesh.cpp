#include "check_readers.h"

#include <cstdint>

/// The first byte chooses the name, since the extension breaks ties between formats.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    if (size == 0)
        return 0;
    static const char *const names[] = {"f.obj", "f.ply", "f.stl", "f.off", "f.glb"};
    const std::string_view bytes(reinterpret_cast<const char *>(data), size);
    ductus::checkMeshReader(bytes.substr(1), names[data[0] % std::size(names)]);
    return 0;
}
