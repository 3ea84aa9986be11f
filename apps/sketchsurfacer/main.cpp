// SketchSurfacer: from a 3D sketch to a piecewise-smooth surface. Without a command the window, with one the
// batch commands, which need no display.
#include "sketchsurfacer/cli/info_command.h"
#include "sketchsurfacer/cli/surface_command.h"
#include "sketchsurfacer/cli/thumbnail_command.h"
#include "sketchsurfacer/ui/run_window.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QTextStream>

namespace {

constexpr const char *usage =
    "SketchSurfacer turns 3D sketches into piecewise-smooth surfaces.\n"
    "\n"
    "Usage: sketchsurfacer [FILE...]\n"
    "       sketchsurfacer COMMAND [OPTIONS]\n"
    "\n"
    "Without a command the window opens, with the files in it: a project, a sketch, a proxy mesh.\n"
    "\n"
    "Commands:\n"
    "  surface IN -o OUT   surface a sketch (sketchsurfacer surface --help lists the options)\n"
    "  info FILE           what a project or mesh holds, and whether it can be printed\n"
    "  thumbnail P.ductus -o OUT.png  a small picture of the sketch with its surface\n"
    "\n"
    "Exit codes: 0 done, 1 failed with the reason on stderr, 2 wrong usage, 3 cancelled.\n";

int wrongUsage(const QString &problem)
{
    QTextStream(stderr) << "sketchsurfacer: " << problem << "\n\n" << usage;
    return int(ductus::ExitCode::WrongUsage);
}

int runBatch(int &argc, char **argv, const QString &command)
{
    QCoreApplication app(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("sketchsurfacer"));
    QCoreApplication::setApplicationVersion(QStringLiteral(DUCTUS_VERSION));
    if (command == QLatin1String("surface"))
        return int(ductus::runSurfaceCommand(QCoreApplication::arguments().mid(2)));
    if (command == QLatin1String("info"))
        return int(ductus::runInfoCommand(QCoreApplication::arguments().mid(2)));
    if (command == QLatin1String("thumbnail"))
        return int(ductus::runThumbnailCommand(QCoreApplication::arguments().mid(2)));
    if (command == QLatin1String("--version") || command == QLatin1String("-v"))
        QTextStream(stdout) << "SketchSurfacer " << DUCTUS_VERSION << "\n";
    else
        QTextStream(stdout) << usage;
    return int(ductus::ExitCode::Done);
}

bool isBatch(const QString &word)
{
    static const QStringList words{QStringLiteral("surface"),   QStringLiteral("info"),
                                   QStringLiteral("thumbnail"), QStringLiteral("help"),
                                   QStringLiteral("--help"),    QStringLiteral("-h"),
                                   QStringLiteral("-v"),        QStringLiteral("--version")};
    return words.contains(word);
}

} // namespace

int main(int argc, char *argv[])
{
    // Read before there is an application: which kind of one is needed is told by the first word.
    QStringList words;
    for (int i = 1; i < argc; ++i)
        words << QFile::decodeName(argv[i]);
    if (!words.isEmpty() && isBatch(words.first()))
        return runBatch(argc, argv, words.first());
    for (const QString &word : words) {
        // -platform, -style and the like are Qt's own
        if (!word.startsWith(QLatin1Char('-')) && !QFileInfo::exists(word))
            return wrongUsage(QStringLiteral("there is no command and no file \"%1\".").arg(word));
    }
#ifdef Q_OS_UNIX
    if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") &&
        qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        return wrongUsage(
            QStringLiteral("there is no display for the window. The batch command needs none."));
#endif
    QStringList files;
    for (const QString &word : words)
        if (!word.startsWith(QLatin1Char('-')))
            files << word;
    return ductus::runSurfacerWindow(argc, argv, files);
}
