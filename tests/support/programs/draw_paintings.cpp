// draw_paintings OUTDIR [--width N] [--samples N] [PAINTING...]: the reference frames of all painting scenes
// of the tests, or of the named Quill and .tilt paintings, as PNG, to look at.
#include "formats/painting_file.h"
#include "formats/png_file.h"
#include "painting/import/painting_import.h"
#include "painting/reference/reference_frame.h"
#include "support/painting_scenes.h"

#include <chrono>
#include <cstdio>
#include <filesystem>

using namespace ductus;

namespace {

/// From the front, a little above, all of it in the picture.
FrameCamera overview(const PaintingSolid &solid)
{
    Box3 box;
    for (std::size_t i = 0; i < solid.stackCount(); ++i)
        if (const LayerSolid *substrate = solid.substrate(i); substrate && !substrate->box().isEmpty()) {
            box.add(substrate->box().min);
            box.add(substrate->box().max);
        }
    if (box.isEmpty())
        box.add(Vec3::Zero());
    const Vec3 eye =
        box.centre() + 0.8 * std::max(box.diagonal(), 1e-6) * Vec3(0.3, 0.35, 1).normalized() * 1.6;
    return FrameCamera::lookingAt(eye, box.centre(), 45, 4.0 / 3);
}

int draw(const std::string &name, const PaintingSolid &solid, const FrameCamera &camera,
         const ReferenceOptions &options, const std::filesystem::path &folder)
{
    const auto begin = std::chrono::steady_clock::now();
    const auto frame = referenceFrame(solid, camera, options, {});
    if (!frame) {
        std::fprintf(stderr, "%s\n", frame.error().message().c_str());
        return 1;
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    std::printf("%-32s %.2f s\n", name.c_str(), seconds);
    const auto written = writePng(frame->colour, folder / (name + ".png"));
    return written ? 0 : 1;
}

} // namespace

int main(int argc, char **argv)
{
    std::vector<std::string> arguments(argv + 1, argv + argc), paintings;
    ReferenceOptions options;
    options.samplesPerAxis = 2;
    std::filesystem::path folder;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (arguments[i] == "--width" && i + 1 < arguments.size())
            options.width = std::atoi(arguments[++i].c_str());
        else if (arguments[i] == "--samples" && i + 1 < arguments.size())
            options.samplesPerAxis = std::atoi(arguments[++i].c_str());
        else if (folder.empty())
            folder = arguments[i];
        else
            paintings.push_back(arguments[i]);
    }
    if (folder.empty()) {
        std::fprintf(stderr, "usage: draw_paintings OUTDIR [--width N] [--samples N] [PAINTING...]\n");
        return 2;
    }
    std::filesystem::create_directories(folder);
    options.height = options.width * 3 / 4;
    int failures = 0;
    if (paintings.empty())
        for (const PaintingScene &scene : allPaintingScenes()) {
            const auto solid = PaintingSolid::make(scene.painting, scene.moment, {});
            failures += solid ? draw(scene.name, *solid, scene.camera, options, folder) : 1;
        }
    for (const std::string &path : paintings) {
        const auto file = readPainting(path, {}, {});
        const auto imported = file ? importPainting(*file) : Result<ImportedPainting>(file.error());
        if (!imported) {
            std::fprintf(stderr, "%s\n", imported.error().message().c_str());
            ++failures;
            continue;
        }
        const auto solid = PaintingSolid::make(imported->painting, {}, {});
        const std::filesystem::path name = std::filesystem::path(path).stem();
        failures += solid ? draw(name, *solid, overview(*solid), options, folder) : 1;
    }
    return failures > 0 ? 1 : 0;
}
