// ductus: what a desktop asks about a project of any app. Without a command it opens projects in the app they
// belong to; `thumbnail` gives their small picture.
#include "cli/thumbnail_output.h"
#include "document/document_files.h"
#include "ductus/project_kind.h"
#include "ductus/project_thumbnail.h"
#include "project/project_reader.h"

#include <QCoreApplication>
#include <QTextStream>

using namespace ductus;

namespace {

constexpr const char *usage =
    "ductus opens projects in the app of the suite they belong to.\n"
    "\n"
    "Usage: ductus P.ductus...\n"
    "       ductus thumbnail P.ductus -o OUT.png [--size N]\n"
    "\n"
    "Commands (ductus COMMAND --help lists the options):\n"
    "  thumbnail P.ductus -o OUT.png  the small picture a project was saved with; without one its app draws "
    "it\n"
    "\n"
    "Exit codes: 0 done, 1 failed with the reason on stderr, 2 wrong usage, 3 cancelled.\n";

int wrongUsage(const QString &problem)
{
    QTextStream(stderr) << "ductus: " << problem << "\n\n" << usage;
    return int(ExitCode::WrongUsage);
}

ExitCode runThumbnail(const QStringList &arguments)
{
    BatchParser parser(QStringLiteral("thumbnail"),
                       QStringLiteral("Writes the small picture of a project, whichever app made it."));
    const ThumbnailOptions options(QStringLiteral("The longer side at most."));
    parser.addPositional(QStringLiteral("P.ductus"), QStringLiteral("The project."));
    parser.addOption(options.output);
    parser.addOption(options.size);
    if (const std::optional<ExitCode> end = parser.parse(arguments, 1, 1))
        return *end;
    return writeThumbnail(parser, options, [&](int pixels, const JobControl &control) {
        return thumbnailOf(parser.positionalPath(0), pixels, control);
    });
}

Result<void> openInItsApp(const QString &file)
{
    const Result<Project> project = openProject(enginePath(file));
    if (!project)
        return project.error();
    const std::optional<LinkedApp> app = appOf(*project);
    if (!app)
        return Error{ErrorCode::Unsupported, "Opening the project", "no app of the suite edits what is in it",
                     "Perhaps a newer version of Ductus made it", file.toStdString()};
    return openInApp(*app, file);
}

ExitCode openEach(const QStringList &files)
{
    TerminalJob job(true);
    ExitCode code = ExitCode::Done;
    for (const QString &file : files)
        if (const Result<void> opened = openInItsApp(file); !opened)
            code = failed(job, opened.error());
    return code;
}

} // namespace

int main(int argc, char **argv)
{
    QCoreApplication app(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("ductus"));
    QCoreApplication::setApplicationVersion(QStringLiteral(DUCTUS_VERSION));
    const QStringList words = QCoreApplication::arguments().mid(1);
    const QString first = words.value(0);
    if (first == QLatin1String("thumbnail"))
        return int(runThumbnail(words.mid(1)));
    if (first == QLatin1String("--version") || first == QLatin1String("-v")) {
        QTextStream(stdout) << "Ductus " << DUCTUS_VERSION << "\n";
        return int(ExitCode::Done);
    }
    if (first == QLatin1String("--help") || first == QLatin1String("-h") || first == QLatin1String("help")) {
        QTextStream(stdout) << usage;
        return int(ExitCode::Done);
    }
    if (first.isEmpty() || first.startsWith(QLatin1Char('-')))
        return wrongUsage(first.isEmpty() ? QStringLiteral("no project is named.")
                                          : QStringLiteral("there is no option \"%1\".").arg(first));
    return int(openEach(words));
}
