#include "journeys/program_run.h"

#include <QDirIterator>
#include <QElapsedTimer>
#include <QProcess>
#include <QRegularExpression>

#include <csignal>
#include <grp.h>
#include <sys/resource.h>
#include <unistd.h>

namespace ductus {

namespace {

constexpr uid_t nobody = 65534;

void limit(__rlimit_resource_t resource, const std::optional<quint64> &bytes)
{
    if (!bytes)
        return;
    const rlimit value{rlim_t(*bytes), rlim_t(*bytes)};
    if (::setrlimit(resource, &value) != 0)
        ::_exit(125);
}

void dropRights()
{
    if (::geteuid() != 0)
        return;
    if (::setgroups(0, nullptr) != 0 || ::setgid(nobody) != 0 || ::setuid(nobody) != 0)
        ::_exit(125);
}

void waitAndSignal(QProcess &process, const RunOptions &options, ProgramRun &run)
{
    QElapsedTimer total, sinceSignal;
    total.start();
    bool isSignalled = options.signalAtProgress.isEmpty();
    while (process.state() != QProcess::NotRunning &&
           total.elapsed() < qint64(options.timeoutSeconds) * 1000) {
        process.waitForReadyRead(20);
        process.waitForFinished(0);
        run.err += QString::fromUtf8(process.readAllStandardError());
        if (!isSignalled && process.state() == QProcess::Running &&
            run.err.contains(QString::fromUtf8(options.signalAtProgress))) {
            isSignalled = true;
            sinceSignal.start();
            ::kill(pid_t(process.processId()), SIGINT);
        }
    }
    if (sinceSignal.isValid())
        run.secondsAfterSignal = double(sinceSignal.elapsed()) / 1e3;
}

} // namespace

ProgramRun runSketchSurfacer(const QStringList &arguments, const RunOptions &options)
{
    return runProgram(QStringLiteral(DUCTUS_SKETCHSURFACER), arguments, options);
}

ProgramRun runProgram(const QString &program, const QStringList &arguments, const RunOptions &options)
{
    QStringList command = options.prefix + QStringList(program) + arguments;
    QProcess process;
    process.setProgram(command.takeFirst());
    process.setArguments(command);
    if (!options.folder.isEmpty())
        process.setWorkingDirectory(options.folder);
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    // The batch commands need no display; with one, no command at all would open the window.
    for (const char *name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        environment.remove(QString::fromLatin1(name));
    for (const QString &variable : options.environment)
        environment.insert(variable.section(QLatin1Char('='), 0, 0), variable.section(QLatin1Char('='), 1));
    process.setProcessEnvironment(environment);
    process.setChildProcessModifier([&options] {
        limit(RLIMIT_FSIZE, options.largestFileBytes);
        limit(RLIMIT_AS, options.largestMemory);
        const rlimit noCore{0, 0};
        ::setrlimit(RLIMIT_CORE, &noCore);
        if (options.withoutRights)
            dropRights();
    });

    ProgramRun run;
    QElapsedTimer timer;
    timer.start();
    process.start();
    run.started = process.waitForStarted();
    if (!run.started)
        return run;
    process.closeWriteChannel();
    waitAndSignal(process, options, run);
    if (process.state() != QProcess::NotRunning) {
        run.hung = true;
        process.kill();
        process.waitForFinished();
    }
    run.seconds = double(timer.elapsed()) / 1e3;
    run.out = QString::fromUtf8(process.readAllStandardOutput());
    run.err += QString::fromUtf8(process.readAllStandardError());
    run.crashed = process.exitStatus() == QProcess::CrashExit;
    run.exitCode = process.exitCode();
    return run;
}

bool canRunWithoutRights()
{
    RunOptions options;
    options.withoutRights = true;
    options.folder = QStringLiteral("/");
    const ProgramRun run = runSketchSurfacer({QStringLiteral("--version")}, options);
    return run.started && !run.crashed && run.exitCode == 0;
}

QStringList ProgramRun::messages() const
{
    static const QRegularExpression progress(QStringLiteral("^ *[0-9]+ %  "));
    QStringList lines;
    for (const QString &line : err.split(QLatin1Char('\n'), Qt::SkipEmptyParts))
        if (!progress.match(line).hasMatch())
            lines.append(line);
    return lines;
}

QByteArray ProgramRun::told() const
{
    return QStringLiteral("exit code %1%2%3\nstdout: %4\nstderr: %5")
        .arg(exitCode)
        .arg(crashed ? QStringLiteral(", crashed") : QString(), hung ? QStringLiteral(", hung") : QString(),
             out, err.right(3000))
        .toUtf8();
}

QStringList namesBelow(const QString &folder)
{
    QStringList names;
    QDirIterator file(folder, QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot,
                      QDirIterator::Subdirectories);
    while (file.hasNext())
        names.append(QDir(folder).relativeFilePath(file.next()));
    names.sort();
    return names;
}

} // namespace ductus
