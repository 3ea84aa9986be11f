// The engine's own words, of errors and of how far a stage is, in the language of the app. They are made
// where there is no Qt, in English; windows translate them, batch commands leave them as they are.
#pragma once

#include <QString>
#include <string_view>

namespace ductus {

/// \a english as a translator has it, else as it is: sentences with a number or a name in them are not
/// translated.
QString engineWords(std::string_view english);

} // namespace ductus
