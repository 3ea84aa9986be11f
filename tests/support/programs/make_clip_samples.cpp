// make_clip_samples OUTDIR: writes the bundled sample clips with their projects.
#include "support/clip_samples.h"

#include <iostream>

int main(int argc, char **argv)
{
    if (argc != 2) {
        std::cerr << "Usage: make_clip_samples OUTDIR\n";
        return 2;
    }
    const auto written = ductus::writeSampleClips(argv[1], {});
    if (!written) {
        std::cerr << written.error().message() << "\n";
        return 1;
    }
    return 0;
}
