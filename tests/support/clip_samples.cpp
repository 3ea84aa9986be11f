#include "support/clip_samples.h"

#include "base/random.h"
#include "doodling/compositing/doodle_painter.h"
#include "doodling/export/export_film.h"
#include "doodling/storage/doodle_content.h"
#include "formats/atomic_file.h"
#include "formats/png_file.h"
#include "project/project_writer.h"
#include "support/clip_doodles.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

namespace ductus {

namespace {

constexpr FrameRate rate{24, 1};

Result<void> writeFilm(const SampleClip &sample, const std::filesystem::path &path, const JobControl &control)
{
    FilmOptions options;
    options.width = sampleWidth;
    options.height = sampleHeight;
    options.rate = rate;
    options.quality = 24; // small: it is bundled
    Result<FilmWriter> film = FilmWriter::open(path, options);
    if (!film)
        return film.error();
    for (int t = 0; t < sample.scene.frameCount; ++t) {
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
    project.documents.push_back(newDocument(
        Uuid::from(random), sample.title,
        std::make_shared<const DoodleContent>(ClipReference{sample.id + ".mp4", sample.scene.frameCount,
                                                            sampleWidth, sampleHeight, rate.perSecond()},
                                              shot, UnknownMembers(), doodles)));
    const Result<SerializedProject> bytes = serializedProject(project);
    if (!bytes)
        return bytes.error();
    return writeFileAtomically(folder / (sample.id + ".ductus"), bytes->bytes, "Writing a sample");
}

} // namespace

std::vector<SampleClip> sampleClips()
{
    return {passingBox(), walkThrough(), pendulum(), chalkYard(), ghostInTheStore(), panOverHills()};
}

Result<void> writeSampleClips(const std::filesystem::path &folder, const std::vector<std::string> &ids,
                              const JobControl &control)
{
    nlohmann::ordered_json list = {
        {"version", 1}, {"made-by", "make_clip_samples; rendered and drawn by the project itself"}};
    list["samples"] = nlohmann::ordered_json::array();
    std::uint64_t seed = 300;
    for (const SampleClip &sample : sampleClips()) {
        ++seed;
        if (ids.empty() || std::ranges::find(ids, sample.id) != ids.end())
            if (Result<void> written = writeSample(sample, seed, folder, control); !written)
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
