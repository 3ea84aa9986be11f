// Actions as JSON: {"action": "setProperties", "objects": {"layer": 5}, "parameters": {"opacity": 0.5}}.
#pragma once

#include "painting/action/action.h"
#include "project/json/json_reader.h"
#include "project/json/json_writer.h"

namespace ductus {

/// Members "action", "objects" and "parameters"; what is not given or stands at its default is left out.
OrderedJson actionToJson(const PaintingAction &action);

/// What is wrong (an unknown action, a missing field) is told through \a reader. Whether the action fits a
/// painting shows when it is performed.
PaintingAction actionFromJson(const JsonReader &reader);

} // namespace ductus
