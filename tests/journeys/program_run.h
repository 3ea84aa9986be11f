// Starts the programs the way a shell does and tells what it said and how it ended.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <functional>
#include <optional>

namespace ductus {

struct RunOptions
{
    QString folder;                          // to start in; empty: the test's own
    std::optional<quint64> largestFileBytes; // RLIMIT_FSIZE: writing more fails as on a full disk
    std::optional<quint64> largestMemory;    // RLIMIT_AS, bytes
    bool withoutRights = false;              // as an unprivileged user where the test runs as root
    QStringList prefix;                      // a program to start it with, "taskset -c 0"
    QStringList environment;                 // "LANG=C" and the like, on top of the test's own
    QByteArray signalAtProgress;             // sends SIGINT once stderr contains this
    int timeoutSeconds = 300;
};

struct ProgramRun
{
    bool started = false;
    bool crashed = false; // ended by a signal
    bool hung = false;    // killed after the timeout
    int exitCode = -1;
    double seconds = 0.0;
    double secondsAfterSignal = -1.0; // from SIGINT to the end; -1 where none was sent
    QString out;
    QString err;

    /// Lines on stderr that are not progress ("  42 %  Fitting the surface").
    QStringList messages() const;
    /// For failure output: exit code and everything said.
    QByteArray told() const;
};

/// `PROGRAM ARGUMENTS`, waited for.
ProgramRun runProgram(const QString &program, const QStringList &arguments, const RunOptions &options = {});

/// `sketchsurfacer ARGUMENTS`, waited for.
ProgramRun runSketchSurfacer(const QStringList &arguments, const RunOptions &options = {});

/// True if withoutRights works here: the test is not root, or the unprivileged user can reach the program.
bool canRunWithoutRights();

/// Names of all files and folders below \a folder, hidden ones too, sorted.
QStringList namesBelow(const QString &folder);

} // namespace ductus
