// SketchSurfacer: from a 3D sketch to a piecewise-smooth surface. Today the batch commands; the window follows.
#include "sketchsurfacer/cli/surface_command.h"

#include <QCoreApplication>
#include <QTextStream>

namespace {

constexpr const char *usage =
    "SketchSurfacer turns 3D sketches into piecewise-smooth surfaces.\n"
    "\n"
    "Usage: sketchsurfacer COMMAND [OPTIONS]\n"
    "\n"
    "Commands:\n"
    "  surface IN -o OUT   surface a sketch (sketchsurfacer surface --help lists the options)\n"
    "\n"
    "Exit codes: 0 done, 1 failed with the reason on stderr, 2 wrong usage, 3 cancelled.\n";

} // namespace

int main(int argc, char *argv[])
{
    QCoreApplication app(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("sketchsurfacer"));
    QCoreApplication::setApplicationVersion(QStringLiteral(DUCTUS_VERSION));
    QStringList arguments = QCoreApplication::arguments();
    arguments.removeFirst();
    const QString command = arguments.isEmpty() ? QString() : arguments.takeFirst();
    if (command == QLatin1String("surface"))
        return int(ductus::runSurfaceCommand(arguments));
    if (command == QLatin1String("--help") || command == QLatin1String("-h") || command == QLatin1String("help")) {
        QTextStream(stdout) << usage;
        return int(ductus::ExitCode::Done);
    }
    if (command == QLatin1String("--version") || command == QLatin1String("-v")) {
        QTextStream(stdout) << "SketchSurfacer " << DUCTUS_VERSION << "\n";
        return int(ductus::ExitCode::Done);
    }
    QTextStream err(stderr);
    if (!command.isEmpty())
        err << "sketchsurfacer: there is no command \"" << command << "\".\n\n";
    err << usage;
    return int(ductus::ExitCode::WrongUsage);
}
