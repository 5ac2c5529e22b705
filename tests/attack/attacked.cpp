// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/attack/attacked.h"

#include <QElapsedTimer>
#include <QTemporaryFile>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace odo::test {

namespace {

constexpr int longestMs = 10'000;
constexpr long mostKb = 500 * 1024;

/// Of what a call wrote, at most so much is kept.
QByteArray written(QTemporaryFile &file)
{
    constexpr qint64 mostKept = 4 << 20;
    file.seek(0);
    return file.read(mostKept);
}

pid_t begin(const QStringList &arguments, int out, int err)
{
    std::vector<QByteArray> words{qgetenv("ODOGRAPH_PROGRAM")};
    for (const QString &argument : arguments)
        words.push_back(argument.toUtf8());
    std::vector<char *> pointers;
    for (QByteArray &word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
        dup2(out, STDOUT_FILENO);
        dup2(err, STDERR_FILENO);
        execv(pointers.front(), pointers.data());
        _exit(127);
    }
    return child;
}

} // namespace

AttackedRun attacked(const QStringList &arguments)
{
    QTemporaryFile out, err;
    if (!out.open() || !err.open())
        qFatal("no temporary file");
    QElapsedTimer time;
    time.start();
    const pid_t child = begin(arguments, out.handle(), err.handle());
    pollfd ending{static_cast<int>(syscall(SYS_pidfd_open, child, 0)), POLLIN, 0};
    if (poll(&ending, 1, longestMs) == 0)
        kill(child, SIGKILL);
    close(ending.fd);
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    AttackedRun run;
    run.seconds = double(time.elapsed()) / 1000;
    run.peakKb = usage.ru_maxrss;
    run.exitStatus = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    run.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    run.out = written(out);
    run.err = written(err);
    return run;
}

QString faultOf(const AttackedRun &run)
{
    const QString said = QString::fromUtf8(run.err.left(400));
    if (run.signal == SIGKILL && run.seconds * 1000 >= longestMs)
        return QStringLiteral("it hangs");
    if (run.signal != 0)
        return QStringLiteral("signal %1: %2").arg(run.signal).arg(said);
    if (run.exitStatus < 0 || run.exitStatus > 2)
        return QStringLiteral("status %1: %2").arg(run.exitStatus).arg(said);
    if (run.peakKb > mostKb)
        return QStringLiteral("%1 MB").arg(run.peakKb / 1024);
    for (const char c : run.out + run.err)
        if ((static_cast<unsigned char>(c) < 32 && c != '\n' && c != '\t') || c == 127)
            return QStringLiteral("the control character %1 is passed on").arg(int(c));
    const bool isOneLine =
        run.err.count('\n') == 1 && run.err.startsWith("odograph: ") && run.err.contains("; ");
    if (run.exitStatus != 0 &&
        (!isOneLine || run.err.contains("nknown error") || QString::fromUtf8(run.err).size() > 2000))
        return QStringLiteral("no line with a reason: %1").arg(said);
    return {};
}

bool isWholeAttack()
{
    return qEnvironmentVariableIsSet("ODOGRAPH_WHOLE_ATTACK");
}

bool isWanted(int number, int oneOf)
{
    return isWholeAttack() || number % oneOf == 0;
}

} // namespace odo::test
