#include "support/painting_samples.h"

#include "formats/atomic_file.h"
#include "painting/storage/painting_content.h"
#include "project/project_writer.h"

#include <nlohmann/json.hpp>

namespace ductus {

std::vector<SamplePaintingFile> samplePaintings()
{
    std::vector<SamplePaintingFile> samples;
    samples.push_back({"forest-path", "Forest path",
                       "Two looks, day and dawn: light is a layer of strokes, mist a gradient.",
                       forestPath()});
    samples.push_back({"plane-over-clouds", "Over the clouds",
                       "Shadows are copies of strokes with tolerance; plane and shadow move as one.",
                       planeOverClouds()});
    samples.push_back({"desk-diorama", "Desk by day and night",
                       "A sunbeam through the window, a lamp for the night: one scene, two looks.",
                       deskDiorama()});
    samples.push_back({"vase", "One vase, three glazes",
                       "Ornament is painted once; looks give every layer another colour.",
                       vaseInThreeGlazes()});
    samples.push_back({"campfire", "Campfire",
                       "Flames are five drawings shown in turn; night and firelight are gradients.",
                       campfire()});
    samples.push_back({"lighthouse", "Lighthouse",
                       "Noise makes foam and crests, the beam is clear paint that turns.", lighthouse()});
    samples.push_back({"koi-pond", "Koi pond",
                       "Spots reach no further than the fish they touch; shadows swim along.", koiPond()});
    return samples;
}

Result<void> writeSamplePaintings(const std::filesystem::path &folder)
{
    nlohmann::ordered_json list = {{"version", 1},
                                   {"made-by", "make_painting_samples; all strokes are the project's own"}};
    list["samples"] = nlohmann::ordered_json::array();
    std::uint64_t seed = 100;
    for (const SamplePaintingFile &sample : samplePaintings()) {
        Random random(++seed);
        Project project;
        project.generator = "LayerPainter";
        project.id = Uuid::from(random);
        project.documents.push_back(
            newDocument(Uuid::from(random), sample.title,
                        std::make_shared<const PaintingContent>(sample.painting, UnknownPaintingMembers())));
        const Result<SerializedProject> written = serializedProject(project);
        if (!written)
            return written.error();
        if (Result<void> done =
                writeFileAtomically(folder / (sample.id + ".ductus"), written->bytes, "Writing a sample");
            !done)
            return done;
        int strokes = 0;
        for (const Layer *layer : sample.painting.layers())
            strokes += layer->elementCount();
        list["samples"].push_back({{"id", sample.id},
                                   {"title", sample.title},
                                   {"lesson", sample.lesson},
                                   {"file", sample.id + ".ductus"},
                                   {"strokes", strokes}});
    }
    return writeFileAtomically(folder / "paintings.json", asBytes(list.dump(2) + "\n"),
                               "Writing the list of samples");
}

} // namespace ductus
