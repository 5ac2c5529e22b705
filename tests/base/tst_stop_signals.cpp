// SPDX-License-Identifier: GPL-3.0-or-later
// What a program does with the signals that ask it to stop; each in a program of its own, for they are the
// whole program's.
#include "core/base/platform/process.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <memory>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

using namespace odo;

namespace {

/// Waits for the first signal, so long that only a test that fails sees the end of it.
bool toldByDescriptor()
{
    pollfd told{stopDescriptor(), POLLIN, 0};
    int seen = 0;
    do
        seen = ::poll(&told, 1, 10'000);
    while (seen < 0);
    return seen == 1;
}

/// Begins a program, sends it the signals, each when it has taken the one before, and gives its wait status.
int statusAfter(const std::vector<int> &signals, const std::function<int()> &last, bool ignoresHangUp = false)
{
    int ready[2];
    if (::pipe(ready) != 0)
        return -1;
    const pid_t child = ::fork();
    if (child == 0) {
        std::signal(SIGHUP, ignoresHangUp ? SIG_IGN : SIG_DFL);
        watchStopSignals();
        static_cast<void>(!::write(ready[1], "", 1));
        for (std::size_t i = 1; i < signals.size(); ++i) {
            if (!toldByDescriptor() || !stopToken().isCancelled())
                ::_exit(1);
            static_cast<void>(!::write(ready[1], "", 1));
        }
        ::_exit(last());
    }
    for (const int signal : signals) {
        char byte = 0;
        if (::read(ready[0], &byte, 1) != 1)
            break;
        ::kill(child, signal);
    }
    int status = -1;
    ::waitpid(child, &status, 0);
    ::close(ready[0]);
    ::close(ready[1]);
    return status;
}

int exitStatus(int status)
{
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

int asAskedToStop()
{
    return toldByDescriptor() && stopToken().isCancelled() ? exitStatusOfStop() : 1;
}

int waitForAnEnd()
{
    ::sleep(10);
    return 0;
}

bool isStoppedAtItsEnd = false;

/// When all that is static has been destroyed: a signal must alter none of the memory that was freed.
[[gnu::destructor]] void stopAtTheEnd()
{
    if (!isStoppedAtItsEnd)
        return;
    using Block = std::array<char, 24>; // as large as the token's own, so these get its memory
    constexpr Block untouched{};
    std::vector<std::unique_ptr<Block>> blocks(1000);
    for (auto &block : blocks)
        block = std::make_unique<Block>(untouched);
    std::raise(SIGTERM);
    const bool isWhole = std::ranges::all_of(blocks, [&](const auto &block) { return *block == untouched; });
    ::_exit(isWhole ? exitStatusOfStop() : 1);
}

int endAndBeStoppedThen()
{
    isStoppedAtItsEnd = true;
    std::exit(0);
}

} // namespace

class TestStopSignals : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void eachAsksToStop()
    {
        QCOMPARE(exitStatus(statusAfter({SIGINT}, asAskedToStop)), 130);
        QCOMPARE(exitStatus(statusAfter({SIGTERM}, asAskedToStop)), 143);
        QCOMPARE(exitStatus(statusAfter({SIGHUP}, asAskedToStop)), 129);
    }

    void aSecondInterruptEndsAtOnce()
    {
        QCOMPARE(exitStatus(statusAfter({SIGINT, SIGINT}, waitForAnEnd)), 130);
    }

    /// As a shell and the system both send it when a terminal is closed.
    void othersMayComeTwice()
    {
        QCOMPARE(exitStatus(statusAfter({SIGHUP, SIGHUP}, asAskedToStop)), 129);
        QCOMPARE(exitStatus(statusAfter({SIGTERM, SIGHUP}, asAskedToStop)), 143);
    }

    void nohupStays()
    {
        const auto stillThere = [] { return stopSignal() == 0 ? 7 : 1; };
        QCOMPARE(exitStatus(statusAfter(
                     {SIGHUP},
                     [&] {
                         ::usleep(100'000);
                         return stillThere();
                     },
                     true)),
                 7);
    }

    void anEndingProgramMayBeStopped() { QCOMPARE(exitStatus(statusAfter({}, endAndBeStoppedThen)), 143); }

    void whereNoSignalCameItIsAnInterrupt()
    {
        QCOMPARE(exitStatusOfStop(), 130);
        QCOMPARE(stopSignal(), 0);
    }
};

ODOGRAPH_TEST(TestStopSignals, QCoreApplication)
#include "tst_stop_signals.moc"
