// Opening a clip for a document: on a worker, with words when it fails.
#pragma once

#include "doodling/clip/clip.h"
#include "doodling/storage/doodle_content.h"

#include <QString>

namespace ductus {

/// A clip that can be read, with its facts.
struct OpenedClip
{
    std::shared_ptr<Clip> clip;
    ClipReference reference; // with the absolute path
};

/// Errors: those of openClip(). For workers.
Result<OpenedClip> openClipFile(const QString &path, const JobControl &control);

/// Whether \a path is a clip by its looks: a video file's suffix, or a folder with pictures.
bool looksLikeClip(const QString &path);

/// Pictures for file dialogs: "*.mp4 *.mov ...".
QString clipPatterns();

/// \a found is not the clip \a known was made of: another number of frames or another size.
bool isOtherClip(const ClipReference &known, const ClipReference &found);

} // namespace ductus
