// Work that must not take the processor from the window.
#pragma once

namespace ductus {

/// Lowers the priority of the calling worker thread, for good, and of the threads it starts. Without a
/// graphics card the picture is drawn by processor threads, too: a solver on all cores would make the view
/// stutter.
void workInBackground();

} // namespace ductus
