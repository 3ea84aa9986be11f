// LayerPainter: 3D paintings coloured with stacks of layers. Without a command the window, with one the batch
// commands, which need no display.
#include "layerpainter/cli/import_command.h"
#include "layerpainter/cli/inspect_commands.h"
#include "layerpainter/cli/render_command.h"
#include "layerpainter/cli/replay_command.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QTextStream>

namespace {

constexpr const char *usage =
    "LayerPainter colours 3D paintings with stacks of layers.\n"
    "\n"
    "Usage: layerpainter COMMAND [OPTIONS]\n"
    "\n"
    "Commands (layerpainter COMMAND --help lists the options):\n"
    "  import IN -o P.ductus   a Quill or .tilt painting or a mesh becomes a project\n"
    "  render IN -o OUT.png    a still, in any look\n"
    "  replay LOG -o P.ductus  an action log or a script of actions becomes a painting\n"
    "  info P.ductus           what a project holds\n"
    "  validate P.ductus       whether a project is sound\n"
    "\n"
    "Exit codes: 0 done, 1 failed with the reason on stderr, 2 wrong usage, 3 cancelled.\n";

using Command = ductus::ExitCode (*)(const QStringList &);

Command commandOf(const QString &word)
{
    if (word == QLatin1String("import"))
        return ductus::runImportCommand;
    if (word == QLatin1String("render"))
        return ductus::runRenderCommand;
    if (word == QLatin1String("replay"))
        return ductus::runReplayCommand;
    if (word == QLatin1String("info"))
        return ductus::runInfoCommand;
    if (word == QLatin1String("validate"))
        return ductus::runValidateCommand;
    return nullptr;
}

} // namespace

int main(int argc, char *argv[])
{
    QCoreApplication app(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("layerpainter"));
    QCoreApplication::setApplicationVersion(QStringLiteral(DUCTUS_VERSION));
    const QStringList words = QCoreApplication::arguments().mid(1);
    const QString first = words.value(0);
    if (const Command command = commandOf(first))
        return int(command(words.mid(1)));
    if (first == QLatin1String("--version") || first == QLatin1String("-v")) {
        QTextStream(stdout) << "LayerPainter " << DUCTUS_VERSION << "\n";
        return int(ductus::ExitCode::Done);
    }
    const bool isHelp =
        first == QLatin1String("--help") || first == QLatin1String("-h") || first == QLatin1String("help");
    if (isHelp) {
        QTextStream(stdout) << usage;
        return int(ductus::ExitCode::Done);
    }
    QTextStream(stderr) << (first.isEmpty()
                                ? QString()
                                : QStringLiteral("layerpainter: there is no command \"%1\".\n\n").arg(first))
                        << usage;
    return int(ductus::ExitCode::WrongUsage);
}
