// --look NAME, as every command that shows a painting takes it.
#pragma once

#include "painting/scene/painting.h"

#include <QString>

namespace ductus {

/// None for an empty name. InvalidArgument for a name no look has, with those there are.
Result<std::optional<LookId>> lookNamed(const Painting &painting, const QString &name);

} // namespace ductus
