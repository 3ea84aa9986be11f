#include "sketchsurfacer/ui/run_window.h"

#include "sketchsurfacer/ui/window/surfacer_window.h"

#include <QApplication>
#include <QTimer>

namespace ductus {

int runWindow(int &argc, char **argv, const QStringList &files)
{
    QApplication app(argc, argv);
    QApplication::setApplicationName(QStringLiteral("sketchsurfacer"));
    QApplication::setApplicationDisplayName(QStringLiteral("SketchSurfacer"));
    QApplication::setOrganizationName(QStringLiteral("ductus"));
    QApplication::setApplicationVersion(QStringLiteral(DUCTUS_VERSION));
    QApplication::setDesktopFileName(QStringLiteral("org.ductus.SketchSurfacer"));
    Settings settings;
    JobRunner jobs;
    ActionCatalogue actions(&settings);
    SurfacerWindow window({&settings, &jobs, &actions});
    window.show();
    QTimer::singleShot(0, &window, [&] {
        for (const QString &file : files)
            window.openPath(file);
    });
    return QApplication::exec();
}

} // namespace ductus
