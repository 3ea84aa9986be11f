// Looks: the layers' properties kept under a name, and taken back by one click.
#pragma once

#include "painting/scene/painting.h"

namespace ductus {

struct AddedLook
{
    Painting painting;
    LookId look;
};

/// Keeps the properties all layers have now.
AddedLook addLook(const Painting &painting, const std::string &name);

/// Overwrites a look by what the layers have now.
Result<Painting> updateLook(const Painting &painting, LookId look);

/// Gives the layers the look's properties; layers made after the look keep theirs. Locks do not matter.
Result<Painting> applyLook(const Painting &painting, LookId look);

Result<Painting> renameLook(const Painting &painting, LookId look, const std::string &name);
Result<Painting> removeLook(const Painting &painting, LookId look);

} // namespace ductus
