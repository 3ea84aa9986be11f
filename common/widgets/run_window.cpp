#include "widgets/run_window.h"

namespace ductus {

void setAppNames(const AppNames &names)
{
    QApplication::setApplicationName(QString::fromLatin1(names.program));
    QApplication::setApplicationDisplayName(QString::fromLatin1(names.display));
    QApplication::setOrganizationName(QStringLiteral("ductus"));
    QApplication::setApplicationVersion(QString::fromLatin1(names.version));
    QApplication::setDesktopFileName(QString::fromLatin1(names.desktopFile));
}

} // namespace ductus
