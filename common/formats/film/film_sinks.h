// The kinds of films, behind FilmWriter.
#pragma once

#include "formats/film/film_writer.h"

namespace ductus {

Result<std::unique_ptr<FilmSink>> openMovie(const std::filesystem::path &path, const FilmOptions &options);
Result<std::unique_ptr<FilmSink>> openGif(const std::filesystem::path &path, const FilmOptions &options);
Result<std::unique_ptr<FilmSink>> openPngFolder(const std::filesystem::path &path,
                                                const FilmOptions &options);

} // namespace ductus
