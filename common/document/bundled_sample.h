// Samples that are opened by their path instead of from the gallery: they must stay as they are, without a
// lock beside them, and open as untitled copies.
#pragma once

#include <QString>

namespace ductus {

/// The id of the bundled sample that \a path is, empty if it is none: the list of samples, \a listName
/// ("paintings.json"), lies in the same folder and names the file.
QString bundledSampleId(const QString &path, const QString &listName);

} // namespace ductus
