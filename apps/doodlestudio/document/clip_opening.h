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

/// The same for a clip that may be \a known at another place: with its digest, unless its facts say already
/// that it is not.
Result<OpenedClip> openMovedClip(const QString &path, const ClipReference &known, const JobControl &control);

/// Whether \a path is a clip by its looks: a video file's suffix, or a folder with pictures.
bool looksLikeClip(const QString &path);

/// Pictures for file dialogs: "*.mp4 *.mov ...".
QString clipPatterns();

/// Whether a clip is the one that is known. Alike: by all that is known of both.
enum class ClipLikeness {
    Other,      // another number of frames or another size
    OtherBytes, // those are the same, what is in the file is not: a copy in another format, perhaps
    Alike,
    Same // byte by byte
};

ClipLikeness likenessOf(const ClipReference &known, const ClipReference &found);

} // namespace ductus
