// A folder of numbered PNGs.
#include "formats/film/film_sinks.h"
#include "formats/film/output_place.h"
#include "formats/png_file.h"

namespace ductus {

namespace {

class PngFolder : public FilmSink
{
public:
    explicit PngFolder(OutputPlace place) : mPlace(std::move(place)) {}

    Result<void> add(const Image &image) override
    {
        return writePng(image, mPlace.path() / numberedPicture(++mCount));
    }
    Result<void> finish() override { return mPlace.commit(); }

private:
    OutputPlace mPlace;
    int mCount = 0;
};

} // namespace

Result<std::unique_ptr<FilmSink>> openPngFolder(const std::filesystem::path &path, const FilmOptions &)
{
    Result<OutputPlace> place = OutputPlace::beside(path, OutputPlace::Kind::Folder);
    if (!place)
        return place.error();
    return std::unique_ptr<FilmSink>(std::make_unique<PngFolder>(std::move(*place)));
}

} // namespace ductus
