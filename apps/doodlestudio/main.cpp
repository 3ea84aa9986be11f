// DoodleStudio: hand-drawn animation that sticks to a filmed scene. Without a command the window, with one
// the batch commands, which need no display.
#include "doodlestudio/cli/analyse_command.h"
#include "doodlestudio/cli/export_command.h"
#include "doodlestudio/cli/inspect_commands.h"
#include "doodlestudio/cli/place_command.h"
#include "doodlestudio/cli/thumbnail_command.h"
#include "doodlestudio/cli/track_command.h"
#include "doodlestudio/cli/update_command.h"
#include "doodlestudio/ui/run_window.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QTextStream>

namespace {

constexpr const char *usage =
    "DoodleStudio pins hand-drawn animation into a filmed scene.\n"
    "\n"
    "Usage: doodlestudio [FILE...]\n"
    "       doodlestudio COMMAND [OPTIONS]\n"
    "\n"
    "Without a command the window opens, with the file in it: a clip, a folder of pictures or a project.\n"
    "\n"
    "Commands (doodlestudio COMMAND --help lists the options):\n"
    "  analyse CLIP -o P.ductus                   finds how the scene moves\n"
    "  track P.ductus --queries Q.json -o T.json  follows points from their keyframes\n"
    "  export P.ductus -o OUT.mp4                 writes the clip with its doodles as a film\n"
    "  place P.ductus PAINTING.ductus --box ...   stands a painting in the scene\n"
    "  update P.ductus                            takes what changed in the paintings that stand in it\n"
    "  thumbnail P.ductus -o OUT.png              draws one frame with its doodles, small\n"
    "  info P.ductus                              says what a project holds\n"
    "  validate P.ductus                          checks a project\n"
    "\n"
    "Exit codes: 0 done, 1 failed with the reason on stderr, 2 wrong usage, 3 cancelled.\n";

using Command = ductus::ExitCode (*)(const QStringList &);

Command commandOf(const QString &word)
{
    if (word == QLatin1String("analyse"))
        return ductus::runAnalyseCommand;
    if (word == QLatin1String("track"))
        return ductus::runTrackCommand;
    if (word == QLatin1String("export"))
        return ductus::runExportCommand;
    if (word == QLatin1String("place"))
        return ductus::runPlaceCommand;
    if (word == QLatin1String("update"))
        return ductus::runUpdatePropsCommand;
    if (word == QLatin1String("thumbnail"))
        return ductus::runThumbnailCommand;
    if (word == QLatin1String("info"))
        return ductus::runInfoCommand;
    if (word == QLatin1String("validate"))
        return ductus::runValidateCommand;
    return nullptr;
}

int wrongUsage(const QString &problem)
{
    QTextStream(stderr) << "doodlestudio: " << problem << "\n\n" << usage;
    return int(ductus::ExitCode::WrongUsage);
}

int runBatch(int &argc, char **argv, const QString &word)
{
    QCoreApplication app(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("doodlestudio"));
    QCoreApplication::setApplicationVersion(QStringLiteral(DUCTUS_VERSION));
    if (const Command command = commandOf(word))
        return int(command(QCoreApplication::arguments().mid(2)));
    if (word == QLatin1String("--version") || word == QLatin1String("-v"))
        QTextStream(stdout) << "doodlestudio " << DUCTUS_VERSION << "\n";
    else
        QTextStream(stdout) << usage;
    return int(ductus::ExitCode::Done);
}

} // namespace

int main(int argc, char **argv)
{
    // Read before there is an application: which kind of one is needed is told by the first word.
    QStringList words;
    for (int i = 1; i < argc; ++i)
        words << QFile::decodeName(argv[i]);
    const QString first = words.value(0);
    static const QStringList asking{QStringLiteral("help"), QStringLiteral("--help"), QStringLiteral("-h"),
                                    QStringLiteral("-v"), QStringLiteral("--version")};
    if (commandOf(first) || asking.contains(first))
        return runBatch(argc, argv, first);
    QStringList files;
    for (const QString &word : words) {
        // -platform, -style and the like are Qt's own
        if (word.startsWith(QLatin1Char('-')))
            continue;
        if (!QFileInfo::exists(word))
            return wrongUsage(QStringLiteral("there is no command and no file \"%1\".").arg(word));
        files << word;
    }
#ifdef Q_OS_UNIX
    if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") &&
        qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        return wrongUsage(
            QStringLiteral("there is no display for the window. The batch commands need none."));
#endif
    return ductus::runStudioWindow(argc, argv, files);
}
