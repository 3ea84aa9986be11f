// Where a clip is that is not where it was: recognised by the hash of its bytes, whatever it is called now.
#pragma once

#include "doodlestudio/document/clip_opening.h"

#include <QStringList>

namespace ductus {

/// Folders in which to look for the clip that was at \a clip, of the project at \a project (empty: not saved
/// yet): theirs first, then those where people keep films.
QStringList placesOfClips(const QString &clip, const QString &project);

/// The clip \a known, which was at \a path, in or right below one of \a folders; those of its name are looked
/// at first. Empty if it is not there, or if its digest is not known. Reads a few gigabytes at most. Errors:
/// Cancelled only.
Result<QString> movedClip(const ClipReference &known, const QString &path, const QStringList &folders,
                          const JobControl &control);

} // namespace ductus
