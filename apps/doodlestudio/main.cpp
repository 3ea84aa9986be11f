// DoodleStudio: hand-drawn animation that sticks to a filmed scene. Batch commands, which need no display.
#include "doodlestudio/cli/analyse_command.h"
#include "doodlestudio/cli/track_command.h"

#include <QCoreApplication>
#include <QTextStream>

namespace {

constexpr const char *usage =
    "DoodleStudio pins hand-drawn animation into a filmed scene.\n"
    "\n"
    "Usage: doodlestudio COMMAND [OPTIONS]\n"
    "\n"
    "Commands (doodlestudio COMMAND --help lists the options):\n"
    "  analyse CLIP -o P.ductus                   finds how the scene moves\n"
    "  track P.ductus --queries Q.json -o T.json  follows points from their keyframes\n"
    "\n"
    "Exit codes: 0 done, 1 failed with the reason on stderr, 2 wrong usage, 3 cancelled.\n";

} // namespace

int main(int argc, char **argv)
{
    QCoreApplication app(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("doodlestudio"));
    QCoreApplication::setApplicationVersion(QStringLiteral(DUCTUS_VERSION));
    const QStringList arguments = QCoreApplication::arguments().mid(1);
    const QString word = arguments.value(0);
    if (word == QLatin1String("analyse"))
        return int(ductus::runAnalyseCommand(arguments.mid(1)));
    if (word == QLatin1String("track"))
        return int(ductus::runTrackCommand(arguments.mid(1)));
    if (word == QLatin1String("--version")) {
        QTextStream(stdout) << "doodlestudio " << QCoreApplication::applicationVersion() << "\n";
        return 0;
    }
    if (word == QLatin1String("--help") || word == QLatin1String("-h")) {
        QTextStream(stdout) << usage;
        return 0;
    }
    QTextStream(stderr) << "doodlestudio: "
                        << (word.isEmpty() ? QStringLiteral("a command is missing")
                                           : QStringLiteral("there is no command \"%1\"").arg(word))
                        << "\n\n"
                        << usage;
    return int(ductus::ExitCode::WrongUsage);
}
