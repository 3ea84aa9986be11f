// A texture mask from pictures: each is a slice of the block, in the order of their names.
#pragma once

#include "base/result.h"
#include "geometry/triangle_mesh.h"
#include "painting/scene/mask.h"

#include <QStringList>

namespace ductus {

/// White lets the layer through, black and clear hold it back. One picture alone goes through the whole
/// block. The block is a cube around \a box (of 1 where that is empty). Sides beyond 256 cells are scaled
/// down. InvalidArgument without pictures, or where they differ in size; Malformed for files that are no
/// pictures.
Result<TextureMask> textureFromPictures(QStringList paths, const Box3 &box);

} // namespace ductus
