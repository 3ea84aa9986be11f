// LayerPainter: 3D paintings coloured with stacks of layers. Without a command the window, with one the batch
// commands, which need no display.
#include "layerpainter/cli/export_command.h"
#include "layerpainter/cli/import_command.h"
#include "layerpainter/cli/inspect_commands.h"
#include "layerpainter/cli/render_command.h"
#include "layerpainter/cli/replay_command.h"
#include "layerpainter/cli/thumbnail_command.h"
#include "layerpainter/cli/update_command.h"
#include "layerpainter/vr/window/run_window.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QTextStream>

namespace {

constexpr const char *usage =
    "LayerPainter colours 3D paintings with stacks of layers.\n"
    "\n"
    "Usage: layerpainter [--vr] [FILE...]\n"
    "       layerpainter COMMAND [OPTIONS]\n"
    "\n"
    "Without a command the window opens, with the file in it; --vr: in a headset as well.\n"
    "\n"
    "Commands (layerpainter COMMAND --help lists the options):\n"
    "  import IN -o P.ductus   a Quill or .tilt painting or a mesh becomes a project\n"
    "  render IN -o OUT        a still (.png) or a film (.mp4, .webm, .gif, folder), in any look\n"
    "  export IN -o OUT.glb    a mesh whose vertices have the layers' colours\n"
    "  replay LOG -o P.ductus  an action log or a script of actions becomes a painting\n"
    "  update P.ductus         takes what changed in the sketches its surfaces were made from\n"
    "  thumbnail P.ductus -o T.png  a small picture\n"
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
    if (word == QLatin1String("export"))
        return ductus::runExportCommand;
    if (word == QLatin1String("replay"))
        return ductus::runReplayCommand;
    if (word == QLatin1String("update"))
        return ductus::runUpdateCommand;
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
    QTextStream(stderr) << "layerpainter: " << problem << "\n\n" << usage;
    return int(ductus::ExitCode::WrongUsage);
}

int runBatch(int &argc, char **argv, const QString &word)
{
    QCoreApplication app(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("layerpainter"));
    QCoreApplication::setApplicationVersion(QStringLiteral(DUCTUS_VERSION));
    if (const Command command = commandOf(word))
        return int(command(QCoreApplication::arguments().mid(2)));
    if (word == QLatin1String("--version") || word == QLatin1String("-v"))
        QTextStream(stdout) << "LayerPainter " << DUCTUS_VERSION << "\n";
    else
        QTextStream(stdout) << usage;
    return int(ductus::ExitCode::Done);
}

} // namespace

int main(int argc, char *argv[])
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
    return ductus::runHeadsetWindow(argc, argv, files, words.contains(QStringLiteral("--vr")));
}
