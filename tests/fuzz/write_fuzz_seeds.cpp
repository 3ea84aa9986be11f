// write_fuzz_seeds FOLDER: the seeds as a corpus for the libFuzzer programs (a sub-folder for each).
#include "painting_project.h"
#include "seeds.h"
#include "support/quill_sample.h"

#include "formats/atomic_file.h"

#include <cstdio>

namespace {

bool write(const std::filesystem::path &folder, const std::string &name, const std::string &bytes)
{
    std::filesystem::create_directories(folder);
    const auto written =
        ductus::writeFileAtomically(folder / name, std::as_bytes(std::span(bytes)), "Writing the seed");
    if (!written)
        std::fprintf(stderr, "%s\n", written.error().message().c_str());
    return written.ok();
}

} // namespace

int main(int argc, char **argv)
{
    if (argc != 2) {
        std::fprintf(stderr, "usage: write_fuzz_seeds FOLDER\n");
        return 2;
    }
    const std::filesystem::path corpus = argv[1];
    bool isFine = write(corpus / "painting", "seed_painting.json", ductus::wholePaintingText()) &&
                  write(corpus / "qbin", "seed_qbin", ductus::quillSample().qbin);
    for (const ductus::Seed &seed : ductus::fuzzSeeds()) {
        static const char *const folders[] = {"sketch", "mesh", "png", "quill", "tilt"};
        // fuzz_sketch and fuzz_mesh take the name from the first byte; the others have only one.
        const bool isNamed = seed.kind == ductus::Seed::Sketch || seed.kind == ductus::Seed::Mesh;
        isFine = isFine && write(corpus / folders[seed.kind], seed.name, (isNamed ? "0" : "") + seed.bytes);
        const std::string extension = std::filesystem::path(seed.name).extension().string();
        if (seed.kind == ductus::Seed::Mesh)
            isFine = isFine && write(corpus / extension.substr(1), seed.name, seed.bytes);
    }
    return isFine ? 0 : 1;
}
