// Sound encoded anew: AAC for MP4, Opus for WebM.
#pragma once

#include "formats/film/sound_source.h"
#include "formats/film/sound_track.h"

namespace ductus {

Result<std::unique_ptr<SoundTrack>> openEncodedSound(SoundSource source, FilmKind kind,
                                                     bool needsGlobalHeader);

} // namespace ductus
