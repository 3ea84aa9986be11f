// An app with its window, from the first line of main() to the last: application, services, files to open.
#pragma once

#include "document/jobs/job_runner.h"
#include "document/settings/action_catalogue.h"
#include "document/settings/settings.h"
#include "widgets/language/language.h"
#include "widgets/main_window_shell.h"

#include <QApplication>
#include <QStringList>
#include <QTimer>

namespace ductus {

/// What the system knows an app by.
struct AppNames
{
    const char *program; // "layerpainter": settings and state are kept under it
    const char *display; // "LayerPainter"
    const char *desktopFile;
    const char *version;
};

/// Tells Qt who the running application is.
void setAppNames(const AppNames &names);

/// Shows a Window (made from ShellServices, with openPath()) with \a files opened in it; the exit code when
/// it is closed.
template <typename Window>
int runWindow(int &argc, char **argv, const AppNames &names, const QStringList &files)
{
    QApplication app(argc, argv);
    setAppNames(names);
    Settings settings;
    speakAsChosen(app, settings, QString::fromLatin1(names.program));
    JobRunner jobs;
    ActionCatalogue actions(&settings);
    Window window(ShellServices{&settings, &jobs, &actions});
    window.show();
    QTimer::singleShot(0, &window, [&] {
        for (const QString &file : files)
            window.openPath(file);
    });
    return QApplication::exec();
}

} // namespace ductus
