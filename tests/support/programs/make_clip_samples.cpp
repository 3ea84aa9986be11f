// make_clip_samples OUTDIR [ID...]: writes the bundled sample clips with their projects, or some of them.
#include "support/clip_samples.h"

#include <iostream>

int main(int argc, char **argv)
{
    if (argc < 2) {
        std::cerr << "Usage: make_clip_samples OUTDIR [ID...]\n";
        return 2;
    }
    const auto written = ductus::writeSampleClips(argv[1], {argv + 2, argv + argc}, {});
    if (!written) {
        std::cerr << written.error().message() << "\n";
        return 1;
    }
    return 0;
}
