// The two projects kill_during_save_test expects and save_loop writes.
#pragma once

#include "project/testing/sample_project.h"

namespace ductus {

/// State 0 or 1: the same project (id), other content; about 100 kB, so that a save takes long enough to be
/// hit.
inline Project killState(int state)
{
    Project project = sampleProject(7);
    project.documents[0].name = state == 0 ? "even" : "odd";
    project.documents[0].sketchSurface = std::make_shared<const SketchSurfaceDocument>(
        sampleSketchSurface(100 + std::uint64_t(state), 40, 100));
    return project;
}

} // namespace ductus
