// write_fuzz_seeds FOLDER: the seeds as a corpus for the libFuzzer programs (sub-folders sketch, mesh, png,
// quill, tilt).
#include "seeds.h"

#include "formats/atomic_file.h"

#include <cstdio>

int main(int argc, char **argv)
{
    if (argc != 2) {
        std::fprintf(stderr, "usage: write_fuzz_seeds FOLDER\n");
        return 2;
    }
    for (const ductus::Seed &seed : ductus::fuzzSeeds()) {
        static const char *const folders[] = {"sketch", "mesh", "png", "quill", "tilt"};
        const std::filesystem::path folder = std::filesystem::path(argv[1]) / folders[seed.kind];
        std::filesystem::create_directories(folder);
        // fuzz_sketch and fuzz_mesh take the name from the first byte; the others have only one.
        const std::string bytes =
            (seed.kind == ductus::Seed::Sketch || seed.kind == ductus::Seed::Mesh ? "0" : "") + seed.bytes;
        const auto written = ductus::writeFileAtomically(folder / seed.name, std::as_bytes(std::span(bytes)),
                                                         "Writing the seed");
        if (!written) {
            std::fprintf(stderr, "%s\n", written.error().message().c_str());
            return 1;
        }
    }
    return 0;
}
