#include "layerpainter/ui/run_window.h"

#include "layerpainter/ui/window/painter_window.h"

#include <QApplication>
#include <QTimer>

namespace ductus {

int runPainterWindow(int &argc, char **argv, const QStringList &files)
{
    QApplication app(argc, argv);
    QApplication::setApplicationName(QStringLiteral("layerpainter"));
    QApplication::setApplicationDisplayName(QStringLiteral("LayerPainter"));
    QApplication::setOrganizationName(QStringLiteral("ductus"));
    QApplication::setApplicationVersion(QStringLiteral(DUCTUS_VERSION));
    QApplication::setDesktopFileName(QStringLiteral("org.ductus.LayerPainter"));
    Settings settings;
    JobRunner jobs;
    ActionCatalogue actions(&settings);
    PainterWindow window({&settings, &jobs, &actions});
    window.show();
    QTimer::singleShot(0, &window, [&] {
        for (const QString &file : files)
            window.openPath(file);
    });
    return QApplication::exec();
}

} // namespace ductus
