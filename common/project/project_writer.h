// A Project as the bytes of a .ductus file. The same project gives the same bytes; what did not change is
// copied packed.
#pragma once

#include "project/project.h"

namespace ductus {

struct SerializedProject
{
    Bytes bytes;
    BufferStore
        buffers; // of the file: put into Project::buffers, so that the next save need not pack them again
    int copiedBuffers = 0; // taken over in packed form
    int packedBuffers = 0; // new, or changed
};

/// Fails with InvalidArgument (place = entry and field) for contents a reader would refuse, TooLarge beyond
/// the limits of a file, NewerVersion for a project that may only be read.
Result<SerializedProject> serializedProject(const Project &project);

} // namespace ductus
