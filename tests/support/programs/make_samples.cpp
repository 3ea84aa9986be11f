// make_samples OUTDIR [--meshes]: writes the bundled sample sketches; with --meshes also the true surfaces as
// OBJ.
#include "support/sample_sketches.h"

#include <iostream>
#include <string>

int main(int argc, char **argv)
{
    const bool meshes = argc == 3 && std::string(argv[2]) == "--meshes";
    if (argc != 2 && !meshes) {
        std::cerr << "Usage: make_samples OUTDIR [--meshes]\n";
        return 2;
    }
    const auto written = ductus::writeSamples(argv[1], meshes);
    if (!written) {
        std::cerr << written.error().message() << "\n";
        return 1;
    }
    return 0;
}
