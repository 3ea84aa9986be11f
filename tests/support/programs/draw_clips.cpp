// draw_clips OUTDIR [WIDTH HEIGHT FRAMES]: the frames of the synthetic clips as PNG, one folder a clip, to
// look at or to analyse.
#include "formats/png_file.h"
#include "support/clip_scenes.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>

using namespace ductus;

int main(int argc, char **argv)
{
    if (argc != 2 && argc != 5) {
        std::fprintf(stderr, "usage: draw_clips OUTDIR [WIDTH HEIGHT FRAMES]\n");
        return 2;
    }
    const int width = argc == 5 ? std::atoi(argv[2]) : 480, height = argc == 5 ? std::atoi(argv[3]) : 270;
    const int frames = argc == 5 ? std::atoi(argv[4]) : 24;
    if (width < 16 || height < 16 || frames < 1) {
        std::fprintf(stderr, "draw_clips: WIDTH and HEIGHT of at least 16, FRAMES of at least 1\n");
        return 2;
    }
    for (const ClipScene &scene : allClipScenes(width, height, frames)) {
        const std::filesystem::path folder = std::filesystem::path(argv[1]) / scene.name;
        std::error_code failure;
        std::filesystem::create_directories(folder, failure);
        for (int t = 0; t < frames; ++t) {
            char name[32];
            std::snprintf(name, sizeof name, "%05d.png", t);
            if (const Result<void> written = writePng(renderedImage(scene, t), folder / name); !written) {
                std::fprintf(stderr, "%s\n", written.error().message().c_str());
                return 1;
            }
        }
        std::printf("%s\n", folder.string().c_str());
    }
    return 0;
}
