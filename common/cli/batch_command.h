// What batch commands share: words on stderr, exit codes, one parser a command. The application's name stands
// before all words.
#pragma once

#include "cli/exit_code.h"
#include "cli/terminal_job.h"

#include <QCommandLineParser>
#include <QStringList>
#include <filesystem>
#include <optional>

namespace ductus {

/// Tells \a error on stderr.
ExitCode failed(TerminalJob &job, const Error &error);

/// A parser with --help and --quiet for `APP COMMAND`.
class BatchParser
{
public:
    BatchParser(const QString &command, const QString &description);

    void addPositional(const QString &name, const QString &description, const QString &syntax = {});
    void addOption(const QCommandLineOption &option);

    /// Nothing if the command can run; else what it ends with, after help or the problem were printed.
    std::optional<ExitCode> parse(const QStringList &arguments, int leastPositional, int mostPositional);
    ExitCode wrongUsage(const QString &problem) const;

    bool isQuiet() const { return mParser.isSet(mQuiet); }
    bool isSet(const QCommandLineOption &option) const { return mParser.isSet(option); }
    QString value(const QCommandLineOption &option) const { return mParser.value(option); }
    std::filesystem::path path(const QCommandLineOption &option) const;
    QStringList positional() const { return mParser.positionalArguments(); }
    std::filesystem::path positionalPath(int index) const;

private:
    QString mCommand;
    QCommandLineParser mParser;
    QCommandLineOption mHelp;
    QCommandLineOption mQuiet;
};

bool hasExtension(const std::filesystem::path &path, const char *extension);

} // namespace ductus
