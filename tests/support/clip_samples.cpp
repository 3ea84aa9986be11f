#include "support/clip_samples.h"

#include "base/random.h"
#include "doodling/canvas/edit_doodle.h"
#include "doodling/canvas/edit_scene.h"
#include "doodling/compositing/doodle_painter.h"
#include "doodling/export/export_film.h"
#include "doodling/storage/doodle_content.h"
#include "formats/atomic_file.h"
#include "formats/png_file.h"
#include "project/project_writer.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <span>

namespace ductus {

namespace {

constexpr int width = 640, height = 360, frames = 72;
constexpr FrameRate rate{24, 1};
constexpr Rgba ink = {35, 30, 45, 255}, red = {225, 60, 50, 255}, yellow = {255, 205, 60, 255};

// A canvas whose middle is at \a place of the world in \a frame, as if it had been dragged there.
Canvas placed(const ClipScene &scene, const std::string &name, int frame, const Vec3 &place,
              const Eigen::Quaterniond &turn = Eigen::Quaterniond::Identity())
{
    const ShotCamera camera = scene.camera(frame);
    Canvas canvas;
    canvas.name = name;
    canvas.keyframes.positions = {
        {frame, camera.projected(place).value_or(Vec2(0.0, 0.0)), camera.depthOf(place), false}};
    canvas.keyframes.turns = {{frame, turn, false}};
    return canvas;
}

InkStroke curve(const std::vector<Vec2> &points, double inkWidth, const Rgba &colour)
{
    InkStroke stroke;
    stroke.colour = colour;
    stroke.width = inkWidth;
    for (std::size_t i = 0; i < points.size(); ++i) {
        stroke.line.points.emplace_back(points[i].x(), points[i].y(), 0.0);
        const double share = points.size() > 1 ? double(i) / double(points.size() - 1) : 0.5;
        stroke.line.pressure.push_back(0.45 + 0.55 * std::sin(std::numbers::pi * share)); // as a pen swells
        stroke.line.timeSeconds.push_back(0.012 * double(i));
    }
    return stroke;
}

std::vector<Vec2> arc(const Vec2 &middle, double rx, double ry, double from, double to)
{
    std::vector<Vec2> points;
    for (int i = 0; i <= 24; ++i) {
        const double angle = from + (to - from) * i / 24.0;
        points.emplace_back(middle + Vec2(rx * std::cos(angle), ry * std::sin(angle)));
    }
    return points;
}

void draw(Canvas &canvas, int frame, DoodleMark mark)
{
    Result<Doodle> drawn = withMark(canvas.doodle, frame, std::move(mark));
    DUCTUS_ASSERT(drawn.ok());
    canvas.doodle = std::move(*drawn);
}

// Three frames: it looks ahead, laughs, blinks.
void drawFace(Canvas &canvas)
{
    constexpr double pi = std::numbers::pi;
    canvas.doodle.frames.assign(3, DoodleFrame{{}, 4});
    canvas.doodle.repeat = DoodleRepeat::PingPong;
    for (int i = 0; i < 3; ++i) {
        const bool isBlinking = i == 2;
        for (double side : {-1.0, 1.0}) {
            const Vec2 eye(0.13 * side, -0.1);
            if (isBlinking) {
                draw(canvas, i, curve(arc(eye, 0.055, 0.03, 0.1 * pi, 0.9 * pi), 0.025, ink));
                continue;
            }
            draw(canvas, i, FilledShape{arc(eye, 0.07, 0.085, 0.0, 2.0 * pi), {255, 255, 255, 255}});
            draw(canvas, i, curve(arc(eye, 0.07, 0.085, 0.0, 2.0 * pi), 0.016, ink));
            draw(canvas, i, FilledShape{arc(eye + Vec2(0.02, 0.01), 0.03, 0.035, 0.0, 2.0 * pi), ink});
        }
        if (i == 1)
            draw(canvas, i, FilledShape{arc({0.0, 0.08}, 0.15, 0.14, 0.0, pi), red});
        draw(canvas, i, curve(arc({0.0, 0.07}, 0.16, i == 1 ? 0.15 : 0.1, 0.05 * pi, 0.95 * pi), 0.028, ink));
    }
}

void add(DoodleScene &scene, Canvas canvas)
{
    Result<DoodleScene> result = withCanvas(scene, std::move(canvas));
    DUCTUS_ASSERT(result.ok());
    scene = std::move(*result);
}

Result<void> writeFilm(const SampleClip &sample, const std::filesystem::path &path, const JobControl &control)
{
    FilmOptions options;
    options.width = width;
    options.height = height;
    options.rate = rate;
    options.quality = 24; // small: it is bundled
    Result<FilmWriter> film = FilmWriter::open(path, options);
    if (!film)
        return film.error();
    for (int t = 0; t < frames; ++t) {
        if (control.isCancelled())
            return cancelledError("Writing a sample");
        if (Result<void> added = film->add(renderedImage(sample.scene, t)); !added)
            return added;
    }
    return film->finish();
}

// Every second cell of every second row: on what moves so evenly nothing is lost.
CompactFlow halved(const CompactFlow &compact)
{
    const FlowField flow = expanded(compact);
    FlowField result{flow.width / 2, flow.height / 2, 2.0 * flow.cellSize, {}, {}};
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x) {
            const std::size_t cell = std::size_t(2 * y) * std::size_t(flow.width) + std::size_t(2 * x);
            result.motions.push_back(flow.motions[cell]);
            result.confidences.push_back(flow.confidences[cell]);
        }
    return result;
}

// What is needed to follow and to hide; the rest is made again by an analysis, and a sample is to be small.
Shot bundled(Shot shot)
{
    for (CompactFlow &flow : shot.forward)
        flow = halved(flow);
    for (CompactFlow &flow : shot.backward)
        flow = halved(flow);
    shot.longFlows = {};
    shot.pictures.clear();
    return shot;
}

Result<void> writeSample(const SampleClip &sample, std::uint64_t seed, const std::filesystem::path &folder,
                         const JobControl &control)
{
    if (Result<void> written = writeFilm(sample, folder / (sample.id + ".mp4"), control); !written)
        return written;
    auto shot = std::make_shared<const Shot>(bundled(trueShot(sample.scene, 8)));
    auto doodles = std::make_shared<const DoodleScene>(sample.doodles);
    const Result<std::vector<CanvasTrack>> tracks = tracksOf(*shot, *doodles, control);
    if (!tracks)
        return tracks.error();
    const Image picture = DoodlePainter().composited({*shot, *doodles, *tracks, sample.pictureFrame},
                                                     renderedImage(sample.scene, sample.pictureFrame));
    if (Result<void> written = writePng(picture, folder / (sample.id + ".png")); !written)
        return written;
    Random random(seed);
    Project project;
    project.generator = "DoodleStudio";
    project.id = Uuid::from(random);
    project.documents.push_back(
        newDocument(Uuid::from(random), sample.title,
                    std::make_shared<const DoodleContent>(
                        ClipReference{sample.id + ".mp4", frames, width, height, rate.perSecond()}, shot,
                        UnknownMembers(), doodles)));
    const Result<SerializedProject> bytes = serializedProject(project);
    if (!bytes)
        return bytes.error();
    return writeFileAtomically(folder / (sample.id + ".ductus"), bytes->bytes, "Writing a sample");
}

} // namespace

SampleClip passingBox()
{
    SampleClip sample{"passing-box",
                      "Passing box",
                      "A face follows the box behind the post; words and arrow stay in the room.",
                      passingScene(width, height, frames),
                      {},
                      24};
    // The front of the box when it starts and when it stops (passingScene).
    const Vec3 middle(0.0, 0.0, -0.31);
    const ClipBody &box = sample.scene.bodies.back();
    Canvas face = placed(sample.scene, "Face", 0, box.worldFromBody(0) * middle,
                         Eigen::Quaterniond(box.worldFromBody(0).linear()));
    face.motion = CanvasMotion::Dynamic;
    face.turning = CanvasTurning::Still;
    // From the second keyframe on straight ahead: behind the post there is nothing to follow.
    for (const int frame : {frames / 4, frames - 1}) {
        const Eigen::Isometry3d pose = box.worldFromBody(frame);
        const ShotCamera camera = sample.scene.camera(frame);
        const Vec3 place = pose * middle;
        face.keyframes.positions.push_back({frame, *camera.projected(place), camera.depthOf(place), true});
        face.keyframes.turns.push_back({frame, Eigen::Quaterniond(pose.linear()), true});
    }
    face.size = Vec2(0.7, 0.8);
    drawFace(face);
    add(sample.doodles, face);

    Canvas words = placed(sample.scene, "Words", 0, {2.15, -0.75, 6.9});
    words.size = Vec2(2.6, 1.0);
    draw(words, 0,
         TextMark{"v = s / t", {0.0, 0.0}, 0.62, 0.0, true, {250, 250, 250, 255}, {30, 45, 80, 255}});
    add(sample.doodles, words);

    // Upright above where the box slides.
    Canvas path = placed(sample.scene, "Path", 36, {0.0, 0.2, 3.1});
    path.size = Vec2(3.0, 0.5);
    draw(path, 0, ArrowMark{{{-1.2, 0.0}, {-0.4, 0.03}, {0.4, 0.0}, {1.2, -0.04}}, 0.06, red});
    add(sample.doodles, path);
    return sample;
}

SampleClip walkThrough()
{
    SampleClip sample{"walk-through",
                      "Walk through the room",
                      "Labels and stickers keep their place in the room while the camera walks in.",
                      forwardScene(width, height, frames),
                      {},
                      40};
    Canvas heavy = placed(sample.scene, "Heavy", 0, {-1.42, -0.45, 3.85});
    heavy.size = Vec2(1.2, 0.9);
    draw(heavy, 0, TextMark{"heavy", {0.0, -0.15}, 0.34});
    draw(heavy, 0, ArrowMark{{{0.0, 0.05}, {-0.02, 0.2}, {0.02, 0.42}}, 0.05, red});
    add(sample.doodles, heavy);

    Canvas star = placed(sample.scene, "Star", 0, {1.32, 0.86, 2.86},
                         Eigen::Quaterniond(Eigen::AngleAxisd(-0.5, Vec3::UnitY())));
    star.doodle.frames.assign(2, DoodleFrame{{}, 6});
    draw(star, 0, StickerMark{"star", {0.0, 0.0}, 0.5, -0.12, yellow});
    draw(star, 1, StickerMark{"star", {0.0, 0.0}, 0.5, 0.12, yellow});
    add(sample.doodles, star);

    Canvas bubble = placed(sample.scene, "Who is there?", 0, {0.95, -0.62, 5.2});
    bubble.size = Vec2(1.3, 1.0);
    bubble.shownFrom = 12;
    draw(bubble, 0, StickerMark{"bubble", {0.0, 0.0}, 1.2, 0.0, ink});
    draw(bubble, 0, TextMark{"Hello!", {0.0, -0.07}, 0.34, 0.0, true, ink, {255, 255, 255, 0}});
    add(sample.doodles, bubble);
    return sample;
}

std::vector<SampleClip> sampleClips()
{
    return {passingBox(), walkThrough()};
}

Result<void> writeSampleClips(const std::filesystem::path &folder, const JobControl &control)
{
    nlohmann::ordered_json list = {
        {"version", 1}, {"made-by", "make_clip_samples; rendered and drawn by the project itself"}};
    list["samples"] = nlohmann::ordered_json::array();
    std::uint64_t seed = 300;
    for (const SampleClip &sample : sampleClips()) {
        if (Result<void> written = writeSample(sample, ++seed, folder, control); !written)
            return written;
        list["samples"].push_back({{"id", sample.id},
                                   {"title", sample.title},
                                   {"lesson", sample.lesson},
                                   {"file", sample.id + ".ductus"},
                                   {"clip", sample.id + ".mp4"}});
    }
    const std::string text = list.dump(2) + "\n";
    return writeFileAtomically(folder / "clips.json", std::as_bytes(std::span(text)),
                               "Writing the list of samples");
}

} // namespace ductus
