// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fault/scarce_attempt.h"
#include "tests/support/said_error.h"

#include <QDataStream>
#include <QFile>
#include <csignal>
#include <filesystem>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace odo::test {

namespace {

constexpr unsigned longestS = 60;

QDataStream &operator<<(QDataStream &out, const ScarceAttempt &attempt)
{
    out << quint64(attempt.requests) << attempt.hasFailed << attempt.error.has_value();
    if (attempt.error)
        out << int(attempt.error->code) << QByteArray::fromStdString(attempt.error->what.english())
            << QByteArray::fromStdString(attempt.error->why.english())
            << QByteArray::fromStdString(attempt.error->advice.english());
    return out;
}

QDataStream &operator>>(QDataStream &in, ScarceAttempt &attempt)
{
    quint64 requests = 0;
    bool isError = false;
    in >> requests >> attempt.hasFailed >> isError;
    attempt.requests = requests;
    if (isError) {
        int code = 0;
        QByteArray what, why, advice;
        in >> code >> what >> why >> advice;
        attempt.error =
            test::saidError(ErrorCode(code), what.toStdString(), why.toStdString(), advice.toStdString());
    }
    return in;
}

/// Does it in a child that tells by a pipe what it came to.
ScarceAttempt inChild(const std::function<ScarceAttempt()> &attempt)
{
    int ends[2];
    if (pipe(ends) != 0)
        qFatal("no pipe");
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        for (const int each : {SIGABRT, SIGSEGV, SIGALRM}) // QtTest would wait for a debugger
            std::signal(each, SIG_DFL);
        alarm(longestS);
        ScarceAttempt tried;
        try {
            tried = attempt();
        } catch (...) {
            _exit(3); // else QtTest would wait for a thread that the parent has
        }
        QFile file;
        if (!file.open(ends[1], QIODevice::WriteOnly))
            _exit(2);
        QDataStream out(&file);
        out << tried;
        file.close();
        _exit(0);
    }
    close(ends[1]);
    ScarceAttempt tried;
    QFile file;
    if (child > 0 && file.open(ends[0], QIODevice::ReadOnly)) {
        QDataStream in(&file);
        in >> tried;
        file.close();
    }
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    tried.signal = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status) != 0 ? -1 : 0;
    return tried;
}

std::optional<Error> errorOf(const Result<void> &result)
{
    return result ? std::nullopt : std::optional(result.error());
}

} // namespace

QString ScarceAttempt::words() const
{
    return QStringLiteral("%1 requests, %2")
        .arg(requests)
        .arg(signal != 0 ? QStringLiteral("ended by signal %1").arg(signal)
             : error     ? QString::fromStdString(error->message())
                         : QStringLiteral("done"));
}

ScarceAttempt attemptWithout(Scarce what, std::uint64_t n, const std::function<Result<void>()> &work)
{
    return inChild([&] {
        ScarceAttempt tried;
        const FailingRequest failing(what, n);
        tried.error = errorOf(work());
        tried.requests = failing.requests();
        tried.hasFailed = failing.hasFailed();
        return tried;
    });
}

ScarceAttempt attemptWithFiles(unsigned files, const std::function<Result<void>()> &work)
{
    return inChild([&] {
        const auto open = std::filesystem::directory_iterator("/proc/self/fd");
        const auto used = static_cast<rlim_t>(std::distance(begin(open), end(open))) - 1; // it was one itself
        rlimit limit{};
        getrlimit(RLIMIT_NOFILE, &limit);
        limit.rlim_cur = used + files;
        setrlimit(RLIMIT_NOFILE, &limit);
        ScarceAttempt tried;
        tried.requests = files;
        tried.error = errorOf(work());
        tried.hasFailed = tried.error.has_value();
        return tried;
    });
}

} // namespace odo::test
