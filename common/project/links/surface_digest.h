// The digest links compare to tell whether a sketch's surface is another one.
#pragma once

#include "project/sketch_surface_document.h"

#include <string>

namespace ductus {

/// SHA-256 of the surface's corners and triangles: what else a sketch stores may change without it.
std::string surfaceDigest(const StoredSurface &surface);

} // namespace ductus
