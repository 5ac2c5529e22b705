// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fault/injected_fault.h"

#include "tests/support/said_error.h"

#include <QDir>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryFile>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <random>
#include <set>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace odo::test {

namespace {

using How = FailingCalls::How;

constexpr unsigned longestWorkS = 60;
constexpr std::size_t textBytes = 2000;

/// What the child tells.
struct Given
{
    FailingCalls calls;
    std::atomic<int> acknowledged = 0;
    bool failed = false;
    ErrorCode code{};
    char what[textBytes] = {}, why[textBytes] = {}, advice[textBytes] = {};
};

void keep(char (&place)[textBytes], const std::string &text)
{
    const std::size_t length = text.copy(place, textBytes - 1);
    place[length] = '\0';
}

/// Memory that two processes share, with a file of its own.
template <class Content>
class Shared
{
public:
    Shared()
    {
        m_file.open();
        m_file.resize(sizeof(Content));
        void *memory =
            ::mmap(nullptr, sizeof(Content), PROT_READ | PROT_WRITE, MAP_SHARED, m_file.handle(), 0);
        if (memory == MAP_FAILED)
            qFatal("no shared memory: %s", std::strerror(errno));
        m_content = new (memory) Content;
    }
    ~Shared() { ::munmap(m_content, sizeof(Content)); }
    Shared(const Shared &) = delete;
    Shared &operator=(const Shared &) = delete;
    Content *operator->() const { return m_content; }
    QString file() const { return m_file.fileName(); }

private:
    QTemporaryFile m_file;
    Content *m_content = nullptr;
};

void report(FailingCalls &calls, const std::filesystem::path &folder, const Fault &fault, int nth)
{
    std::snprintf(calls.folder, sizeof calls.folder, "%s", folder.c_str());
    calls.nth = nth;
    calls.error = fault.error;
    calls.how = fault.how;
    calls.reads = fault.reads;
}

void ask(Attempt &attempt, const FailingCalls &calls)
{
    attempt.calls = calls.count;
    attempt.reached = calls.failed > 0;
    if (attempt.reached)
        attempt.failedCall = QString::fromLatin1(calls.call) + u' ' + QString::fromUtf8(calls.path);
}

} // namespace

QString Fault::words() const
{
    switch (how) {
    case How::Killed:
        return QStringLiteral("SIGKILL");
    case How::KilledHalfway:
        return QStringLiteral("SIGKILL halfway");
    default:
        break;
    }
    const QString name = error == ENOSPC  ? QStringLiteral("ENOSPC")
                         : error == EROFS ? QStringLiteral("EROFS")
                         : error == EIO   ? QStringLiteral("EIO")
                                          : QStringLiteral("nothing");
    return name + (how == How::FromThenOn ? QStringLiteral(" from then on") : QString()) +
           (reads ? QStringLiteral(", reading too") : QString());
}

const std::vector<Fault> &allFaults()
{
    static const std::vector<Fault> faults = {
        {EIO, How::Once, true},           {EIO, How::FromThenOn, false},   {ENOSPC, How::Once, false},
        {ENOSPC, How::FromThenOn, false}, {EROFS, How::FromThenOn, false}, {0, How::Killed, false},
        {0, How::KilledHalfway, false},
    };
    return faults;
}

std::vector<Fault> kills()
{
    std::vector<Fault> some;
    std::ranges::copy_if(allFaults(), std::back_inserter(some), &Fault::kills);
    return some;
}

std::vector<Fault> failures()
{
    std::vector<Fault> some;
    std::ranges::copy_if(allFaults(), std::back_inserter(some),
                         [](const Fault &fault) { return !fault.kills(); });
    return some;
}

QString Attempt::words() const
{
    return QStringLiteral("call %1 of %2 (%3): %4%5")
        .arg(nth)
        .arg(calls)
        .arg(failedCall, fault.words(),
             error ? QStringLiteral("; it said: ") + QString::fromStdString(error->message()) : QString());
}

Attempt attempt(const std::filesystem::path &folder, const Fault &fault, int nth, const Work &work)
{
    const Shared<Given> told;
    report(told->calls, folder, fault, nth);
    std::fflush(nullptr);
    const pid_t child = ::fork();
    if (child < 0)
        qFatal("no child process: %s", std::strerror(errno));
    if (child == 0) {
        ::alarm(longestWorkS); // what hangs is ended by SIGALRM
        odographSetFailingCalls(&told->calls);
        const Result<void> done = work(folder, [&told] { ++told->acknowledged; });
        odographSetFailingCalls(nullptr);
        if (!done) {
            told->failed = true;
            told->code = done.error().code;
            keep(told->what, done.error().what.english());
            keep(told->why, done.error().why.english());
            keep(told->advice, done.error().advice.english());
        }
        ::_exit(0);
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    Attempt attempt;
    attempt.fault = fault;
    attempt.nth = nth;
    ask(attempt, told->calls);
    attempt.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    attempt.acknowledged = told->acknowledged;
    if (told->failed)
        attempt.error = test::saidError(told->code, told->what, told->why, told->advice);
    return attempt;
}

struct AttemptedProgram::Impl
{
    Attempt attempt;
    Shared<FailingCalls> calls;
    QProcess process;
};

AttemptedProgram::AttemptedProgram(const std::filesystem::path &folder, const Fault &fault, int nth,
                                   const QStringList &arguments)
    : m_impl(std::make_unique<Impl>())
{
    m_impl->attempt.fault = fault;
    m_impl->attempt.nth = nth;
    report(*m_impl->calls.operator->(), folder, fault, nth);
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("LD_PRELOAD"), qEnvironmentVariable("ODOGRAPH_FAILING_CALLS_LIBRARY"));
    environment.insert(QString::fromLatin1(failingCallsVariable), m_impl->calls.file());
    environment.insert(QStringLiteral("ASAN_OPTIONS"), environment.value(QStringLiteral("ASAN_OPTIONS")) +
                                                           QStringLiteral(":verify_asan_link_order=0"));
    m_impl->process.setProcessEnvironment(environment);
    m_impl->process.start(qEnvironmentVariable("ODOGRAPH_PROGRAM"), arguments);
}

AttemptedProgram::~AttemptedProgram() = default;

Attempt AttemptedProgram::finish(ProgramRun *run)
{
    QProcess &process = m_impl->process;
    const bool hangs =
        !process.waitForFinished(longestWorkS * 1000) && process.state() != QProcess::NotRunning;
    if (hangs) {
        process.kill();
        process.waitForFinished();
    }
    run->exitStatus = process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
    run->out = process.readAllStandardOutput();
    run->err = process.readAllStandardError();
    Attempt attempt = m_impl->attempt;
    ask(attempt, *m_impl->calls.operator->());
    const bool isKilled = attempt.fault.kills() && attempt.reached && !hangs;
    attempt.signal = run->exitStatus != -1 ? 0 : isKilled ? SIGKILL : hangs ? SIGALRM : SIGABRT;
    return attempt;
}

Attempt attemptProgram(const std::filesystem::path &folder, const Fault &fault, int nth,
                       const QStringList &arguments, ProgramRun *run)
{
    return AttemptedProgram(folder, fault, nth, arguments).finish(run);
}

bool isWholeSweep()
{
    return qEnvironmentVariableIsSet("ODOGRAPH_ALL_FAULTS");
}

std::vector<int> spreadCalls(int calls, int count)
{
    static std::mt19937 random(
        qEnvironmentVariableIsSet("ODOGRAPH_SEED") ? qEnvironmentVariableIntValue("ODOGRAPH_SEED") : 1);
    std::set<int> chosen;
    const int parts = std::min(calls, count);
    for (int part = 0; part < parts; ++part)
        chosen.insert(
            std::uniform_int_distribution(calls * part / parts + 1, calls * (part + 1) / parts)(random));
    return {chosen.begin(), chosen.end()};
}

QString quickFolder()
{
    const QFileInfo memory(QStringLiteral("/dev/shm"));
    return (memory.isDir() && memory.isWritable() ? memory.filePath() : QDir::tempPath()) +
           QStringLiteral("/fault-XXXXXX");
}

void copyFolder(const std::filesystem::path &from, const std::filesystem::path &to)
{
    std::filesystem::remove_all(to);
    std::filesystem::copy(from, to, std::filesystem::copy_options::recursive);
}

} // namespace odo::test
