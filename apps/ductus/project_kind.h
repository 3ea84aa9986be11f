// Which app a project belongs to.
#pragma once

#include "document/linked_app.h"
#include "project/project.h"

#include <optional>

namespace ductus {

/// The app that saved \a project last, if it is one of the suite and edits a document in it; else the app of
/// the last document that has one (what was made of a sketch comes after it). Nothing for projects without
/// any.
std::optional<LinkedApp> appOf(const Project &project);

} // namespace ductus
