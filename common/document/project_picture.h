// The picture of a project: thumbnail.png in the container, at most 256 pixels.
#pragma once

#include "project/project.h"

#include <QImage>

namespace ductus {

/// Null if there is none or it is no PNG of a reasonable size.
QImage projectThumbnail(const Project &project);

/// Scales \a picture down where needed; a null one removes the thumbnail.
void setProjectThumbnail(Project &project, const QImage &picture);

} // namespace ductus
