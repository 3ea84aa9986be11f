#include "layerpainter/cli/look_argument.h"

namespace ductus {

Result<std::optional<LookId>> lookNamed(const Painting &painting, const QString &name)
{
    if (name.isEmpty())
        return std::optional<LookId>();
    std::string names;
    for (const Look &look : painting.looks) {
        if (QString::fromStdString(look.name).compare(name, Qt::CaseInsensitive) == 0)
            return std::optional<LookId>(look.id);
        names += (names.empty() ? "" : ", ") + look.name;
    }
    return Error{ErrorCode::InvalidArgument, "Choosing the look",
                 "there is no look \"" + name.toStdString() + "\"",
                 names.empty() ? "Leave --look out: the painting has none" : "Choose one of: " + names, ""};
}

} // namespace ductus
