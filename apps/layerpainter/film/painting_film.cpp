#include "layerpainter/film/painting_film.h"

#include "formats/film/film_writer.h"

namespace ductus {

namespace {

constexpr const char *attempted = "Writing the film";

Error invalid(const std::string &problem, const std::string &remedy, const std::filesystem::path &path)
{
    return {ErrorCode::InvalidArgument, attempted, problem, remedy, path.string()};
}

} // namespace

Result<void> writeFilm(std::shared_ptr<const Painting> painting, const PaintingFilm &film,
                       const std::filesystem::path &path, const JobControl &control)
{
    const std::optional<FilmKind> kind = filmKindOf(path);
    if (!kind)
        return invalid("no kind of film ends in \"" + path.extension().string() + "\"",
                       "Give a name that ends in .mp4, .webm or .gif, or the name of a folder", path);
    if (film.frames.transparentBackground && *kind == FilmKind::Mp4)
        return invalid("MP4 has no transparency", "Choose WebM, GIF or a folder of pictures", path);
    if (film.plan.frames < 1)
        return invalid("the film has no frames", "Make it longer", path);

    FilmOptions options;
    options.kind = *kind;
    options.width = film.frames.width;
    options.height = film.frames.height;
    options.rate = film.plan.rate;
    options.keepsAlpha = film.frames.transparentBackground;
    options.quality = film.quality;
    Result<FilmWriter> writer = FilmWriter::open(path, options);
    if (!writer)
        return writer.error();
    const std::unique_ptr<FrameMaker> frames = makeFrames(painting, film.frames);
    const double aspect = double(film.frames.width) / film.frames.height;
    for (int i = 0; i < film.plan.frames; ++i) {
        const double begin = double(i) / film.plan.frames, end = double(i + 1) / film.plan.frames;
        control.progress(begin, "Frame " + std::to_string(i + 1) + " of " + std::to_string(film.plan.frames));
        if (control.isCancelled())
            return cancelledError(attempted);
        const Result<Image> image =
            frames->frame({secondOf(film.plan, i), film.look}, cameraOf(*painting, film.plan, i, aspect),
                          control.part(begin, end).silenced());
        if (!image)
            return image.error();
        if (const Result<void> added = writer->add(*image); !added)
            return added;
    }
    if (control.isCancelled())
        return cancelledError(attempted);
    return writer->finish();
}

std::filesystem::path pathForLook(const std::filesystem::path &path, const std::string &look, int number)
{
    std::string name;
    for (const char c : look)
        if (std::string_view("/\\:*?\"<>|").find(c) == std::string_view::npos && std::uint8_t(c) >= ' ')
            name += c;
    if (name.empty())
        name = std::to_string(number);
    std::filesystem::path named = path;
    named.replace_filename(path.stem().string() + "-" + name + path.extension().string());
    return named;
}

} // namespace ductus
