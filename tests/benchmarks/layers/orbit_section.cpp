#include "benchmarks/layers/orbit_section.h"

#include "benchmarks/layers/stroke_scene.h"
#include "render/gl/gl_object.h"
#include "render/painting_renderer.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>

namespace ductus {

namespace {

constexpr int width = 930, height = 690; // of the canvas in a window of 1280 x 800

struct Way
{
    const char *name;
    int divisor; // window pixels along a pixel
    RenderOptions options;
};

// As apps/layerpainter/ui/view has them.
constexpr Way ways[] = {{"exact", 1, {}},
                        {"still", 1, {1, false, 0.5, 0.25}},
                        {"turning, 1/2", 2, {1, false, 1.0, 1.0, 4.0, 200'000}},
                        {"turning, 1/3", 3, {1, false, 1.0, 1.0, 4.0, 200'000}},
                        {"turning, 1/6", 6, {1, false, 1.0, 1.0, 4.0, 200'000}},
                        {"exact ones, 1/6", 6, {1, false, 1.0, 1.0}}};

} // namespace

nlohmann::json measureOrbit(int strokes)
{
    const StrokeScene scene = strokeScene(strokes, 0, 7);
    nlohmann::json report = nlohmann::json::array();
    std::printf("%d strokes on a canvas of %d x %d\n%16s %10s %10s %10s %10s\n", strokes, width, height,
                "frame", "CPU ms", "wall ms", "segments", "ribbons");
    for (const Way &way : ways) {
        Result<PaintingRenderer> renderer = PaintingRenderer::create(way.options);
        if (!renderer || !renderer->update(scene.painting, {})) {
            std::printf("%14s failed\n", way.name);
            continue;
        }
        double processor = 1e300, wall = 1e300;
        for (int i = 0; i < 4; ++i) {
            // As far as a hand turns the view between two frames.
            FrameCamera camera = scene.camera;
            const Eigen::AngleAxisd turn(0.02 * i, Vec3::UnitY());
            camera.eye = turn * camera.eye;
            camera.rotation = turn * camera.rotation;
            const auto begin = std::chrono::steady_clock::now();
            const std::clock_t clock = std::clock();
            if (!renderer->image(camera, width / way.divisor, height / way.divisor))
                std::printf("a frame failed\n");
            if (i == 0)
                continue; // compiles shaders
            processor = std::min(processor, 1000.0 * double(std::clock() - clock) / CLOCKS_PER_SEC);
            wall = std::min(
                wall,
                std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
        }
        std::printf("%16s %10.0f %10.0f %10llu %10llu\n", way.name, processor, wall,
                    static_cast<unsigned long long>(renderer->statistics().segments),
                    static_cast<unsigned long long>(renderer->statistics().ribbonVertices));
        report.push_back({{"frame", way.name},
                          {"strokes", strokes},
                          {"processorMilliseconds", processor},
                          {"milliseconds", wall}});
    }
    return report;
}

} // namespace ductus
