#include "cli/batch_command.h"

#include <QCoreApplication>
#include <cstdio>

namespace ductus {

ExitCode failed(TerminalJob &job, const Error &error)
{
    job.finishLine();
    std::fprintf(stderr, "%s: %s\n", qPrintable(QCoreApplication::applicationName()),
                 error.message().c_str());
    return exitCodeFor(error);
}

BatchParser::BatchParser(const QString &command, const QString &description)
    : mCommand(command),
      mHelp({QStringLiteral("h"), QStringLiteral("help")}, QStringLiteral("Shows this help.")),
      mQuiet({QStringLiteral("q"), QStringLiteral("quiet")}, QStringLiteral("No progress on stderr."))
{
    mParser.setApplicationDescription(
        description +
        QStringLiteral("\n\nExit codes: 0 done, 1 failed with the reason on stderr, 2 wrong usage, "
                       "3 cancelled (Ctrl-C)."));
    mParser.addOptions({mHelp, mQuiet});
}

void BatchParser::addPositional(const QString &name, const QString &description, const QString &syntax)
{
    mParser.addPositionalArgument(name, description, syntax);
}

void BatchParser::addOption(const QCommandLineOption &option)
{
    mParser.addOption(option);
}

std::optional<ExitCode> BatchParser::parse(const QStringList &arguments, int leastPositional,
                                           int mostPositional)
{
    if (!mParser.parse(QStringList(QCoreApplication::applicationName() + QLatin1Char(' ') + mCommand) +
                       arguments))
        return wrongUsage(mParser.errorText());
    if (mParser.isSet(mHelp)) {
        std::fputs(qPrintable(mParser.helpText()), stdout);
        return ExitCode::Done;
    }
    if (positional().size() < leastPositional)
        return wrongUsage(QStringLiteral("a file is missing"));
    if (positional().size() > mostPositional)
        return wrongUsage(QStringLiteral("\"%1\" is one file too many").arg(positional().at(mostPositional)));
    return std::nullopt;
}

ExitCode BatchParser::wrongUsage(const QString &problem) const
{
    std::fputs(qPrintable(QStringLiteral("%1 %2: %3. See: %1 %2 --help\n")
                              .arg(QCoreApplication::applicationName(), mCommand, problem)),
               stderr);
    return ExitCode::WrongUsage;
}

std::filesystem::path BatchParser::path(const QCommandLineOption &option) const
{
    return std::filesystem::path(value(option).toStdU16String());
}

std::filesystem::path BatchParser::positionalPath(int index) const
{
    return std::filesystem::path(positional().at(index).toStdU16String());
}

bool hasExtension(const std::filesystem::path &path, const char *extension)
{
    return QString::fromStdString(path.extension().string())
               .compare(QLatin1String(extension), Qt::CaseInsensitive) == 0;
}

} // namespace ductus
