#include "document/recovery/state_folder.h"

#include <QDir>

namespace ductus {

QString stateFolder(const QString &application, const QString &name)
{
    QString base = qEnvironmentVariable("XDG_STATE_HOME");
    // The specification tells to ignore relative ones.
    if (base.isEmpty() || !QDir::isAbsolutePath(base))
        base = QDir::homePath() + QStringLiteral("/.local/state");
    return QDir::cleanPath(base + QLatin1Char('/') + application + QLatin1Char('/') + name);
}

} // namespace ductus
