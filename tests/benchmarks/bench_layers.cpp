// What layers cost: frame times of strokes in layers divided by those of the same strokes as plain shape, in
// the same process and context. painting.md section 3. `./run bench layers [--quick] [--json FILE]`;
// `--orbit` measures what turning 57,000 strokes costs instead.
#include "benchmarks/layers/orbit_section.h"
#include "benchmarks/layers/stencil_baseline.h"
#include "benchmarks/layers/stroke_scene.h"
#include "render/gl/offscreen_context.h"
#include "render/painting_renderer.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <iostream>
#include <string>

using namespace ductus;

namespace {

constexpr int side = 512;

/// Of the processor, all threads: software rendering works there, and what else the machine does counts
/// little. With a graphics card see the wall times.
struct Cost
{
    double processor = 1e300;
    double wall = 1e300;
};

Cost costOf(const std::function<void()> &draw)
{
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t processor = std::clock();
    draw();
    glFinish();
    return {1000.0 * double(std::clock() - processor) / CLOCKS_PER_SEC,
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count()};
}

/// A renderer with a target for each of its views.
class Subject
{
public:
    Subject(const StrokeScene &scene, int views) : mRenderer(take(PaintingRenderer::create({})))
    {
        mTexture = GlTexture::create();
        mTarget = GlFramebuffer::create();
        glBindTexture(GL_TEXTURE_2D, mTexture.name());
        glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, side * views, side);
        glBindFramebuffer(GL_FRAMEBUFFER, mTarget.name());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, mTexture.name(), 0);
        for (int i = 0; i < views; ++i) {
            FrameCamera camera = scene.camera;
            camera.eye += camera.rotation * Vec3(0.065 * i, 0, 0);
            mViews.push_back({camera, mTarget.name(), side * i, 0, side, side});
        }
        check(mRenderer.update(scene.painting, {}));
    }

    void draw() { check(mRenderer.render(mViews)); }
    int draws() const { return mRenderer.statistics().draws; }

private:
    static PaintingRenderer take(Result<PaintingRenderer> made)
    {
        if (!made)
            check(made.error());
        return std::move(*made);
    }
    static void check(const Result<void> &done)
    {
        if (done)
            return;
        std::cerr << done.error().message() << "\n";
        std::exit(1);
    }

    PaintingRenderer mRenderer;
    GlTexture mTexture;
    GlFramebuffer mTarget;
    std::vector<RenderView> mViews;
};

/// Least of several frames, taken in turns so that what else the machine does strikes all alike.
std::vector<Cost> race(const std::vector<std::function<void()>> &runners, int rounds)
{
    std::vector<Cost> best(runners.size());
    for (int round = 0; round <= rounds; ++round)
        for (std::size_t i = 0; i < runners.size(); ++i) {
            const Cost cost = costOf(runners[i]);
            if (round == 0)
                continue; // compiles shaders
            best[i].processor = std::min(best[i].processor, cost.processor);
            best[i].wall = std::min(best[i].wall, cost.wall);
        }
    return best;
}

} // namespace

int main(int argc, char **argv)
{
    bool quick = false, orbit = false;
    std::string jsonPath;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        if (argument == "--quick") {
            quick = true;
        } else if (argument == "--orbit") {
            orbit = true;
        } else if (argument == "--json" && i + 1 < argc) {
            jsonPath = argv[++i];
        } else {
            std::cerr << "usage: bench_layers [--quick | --orbit] [--json FILE]\n";
            return 2;
        }
    }
    Result<OffscreenContext> context = OffscreenContext::create();
    if (!context) {
        std::cerr << context.error().message() << "\n";
        return 1;
    }
    std::printf("%s, %dx%d pixels a view\n", context->description().c_str(), side, side);
    if (orbit) {
        const nlohmann::json report = measureOrbit(57'000);
        if (!jsonPath.empty() && !(std::ofstream(jsonPath) << report.dump(2) << "\n")) {
            std::cerr << "bench_layers: " << jsonPath << " cannot be written\n";
            return 1;
        }
        return 0;
    }
    std::printf("%8s %7s %6s | %10s %8s %6s %8s | %10s %8s %6s %8s | %6s | %8s %8s %6s %6s\n", "strokes",
                "layers", "views", "plain CPU", "layered", "ratio", "stencil", "plain wall", "layered",
                "ratio", "stencil", "draws", "layers", "stencil", "times", "whole");
    nlohmann::json report = nlohmann::json::array();
    const std::vector<int> strokeCounts = quick ? std::vector<int>{432} : std::vector<int>{432, 2000, 10000};
    for (const int strokes : strokeCounts) {
        for (const int layers : {8, 64}) {
            for (const int views : {1, 2}) {
                const StrokeScene layered = strokeScene(strokes, layers, 7),
                                  plain = strokeScene(strokes, 0, 7);
                StrokeScene shapes = layered;
                for (Layer &layer : shapes.painting.stacks[0].appearance)
                    layer.properties.visible = false;
                Subject layeredSubject(layered, views), plainSubject(plain, views),
                    shapesSubject(shapes, views);
                Result<StencilBaseline> stencil = StencilBaseline::create(layered.painting, side, side);
                if (!stencil) {
                    std::cerr << stencil.error().message() << "\n";
                    return 1;
                }
                const std::vector<Cost> costs =
                    race({[&] { plainSubject.draw(); }, [&] { layeredSubject.draw(); },
                          [&] {
                              for (int i = 0; i < views; ++i)
                                  stencil->draw(layered.camera);
                          },
                          [&] { shapesSubject.draw(); },
                          [&] {
                              for (int i = 0; i < views; ++i)
                                  stencil->draw(layered.camera, false);
                          }},
                         quick ? 2 : 5);
                std::printf("%8d %7d %6d |", strokes, layers, views);
                for (double Cost::*time : {&Cost::processor, &Cost::wall})
                    std::printf(" %10.1f %8.1f %6.2f %8.1f |", costs[0].*time, costs[1].*time,
                                costs[1].*time / (costs[0].*time), costs[2].*time);
                const double ours = costs[1].processor - costs[3].processor;
                const double theirs = costs[2].processor - costs[4].processor;
                std::printf(" %6d | %8.1f %8.1f %6.2f %6.2f\n", layeredSubject.draws(), ours, theirs,
                            theirs / ours, costs[2].processor / costs[1].processor);
                std::fflush(stdout);
                report.push_back({{"strokes", strokes},
                                  {"layers", layers},
                                  {"views", views},
                                  {"plainMilliseconds", costs[0].wall},
                                  {"layeredMilliseconds", costs[1].wall},
                                  {"stencilMilliseconds", costs[2].wall},
                                  {"plainProcessorMilliseconds", costs[0].processor},
                                  {"layeredProcessorMilliseconds", costs[1].processor},
                                  {"stencilProcessorMilliseconds", costs[2].processor},
                                  {"layersAloneProcessorMilliseconds", ours},
                                  {"stencilLayersAloneProcessorMilliseconds", theirs}});
            }
        }
    }
    std::printf(
        "ratio: layered / plain, target <= 1.5 at 432 strokes in 8 layers. stencil: the thesis' three draws "
        "a "
        "stroke, on meshes\nwith eight sides, two whole-frame passes a layer. layers, stencil, times: what "
        "the layers alone cost, CPU; whole: stencil / layered\nwith the shapes; target >= 3.\n");
    if (!jsonPath.empty() && !(std::ofstream(jsonPath) << report.dump(2) << "\n")) {
        std::cerr << "bench_layers: " << jsonPath << " cannot be written\n";
        return 1;
    }
    return 0;
}
