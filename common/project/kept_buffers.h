// Which buffers of a project must survive a save although no document known here refers to them.
#pragma once

#include "project/project.h"

namespace ductus {

/// All buffers but those only known fields refer to (\a usedBuffers, hashes). A buffer counts as referred to
/// elsewhere when its hash stands in a kept entry, in a document that is saved as it came or in a field that
/// is not known.
std::set<std::string> buffersToKeep(const Project &project, const std::set<std::string> &usedBuffers);

/// Hashes of the buffers of \a store that stand in \a text.
std::set<std::string> mentionedBuffers(std::string_view text, const BufferStore &store);

} // namespace ductus
