// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/platform/stop_signals.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <unistd.h>

namespace odo {

namespace {

constexpr int shellsBase = 128;

// A signal handler can reach nothing but globals, and may do little more than store to them and write().
const CancelToken token;
std::atomic<int> firstSignal{0};
std::array<int, 2> ends{-1, -1}; // of a pipe

void onStop(int signal)
{
    const int before = firstSignal.load();
    if (signal == SIGINT && before == SIGINT)
        ::_exit(shellsBase + SIGINT);
    const int error = errno;
    if (before == 0 || signal == SIGINT) // what counts is the person
        firstSignal = signal;
    token.cancel();
    if (before == 0 && ends[1] >= 0)
        static_cast<void>(!::write(ends[1], "", 1));
    errno = error;
}

} // namespace

void watchStopSignals()
{
    if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0)
        ends = {-1, -1};
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction before = {}, action = {};
        if (signal == SIGHUP && ::sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN)
            continue;
        action.sa_handler = onStop;
        action.sa_flags = SA_RESTART;
        ::sigaction(signal, &action, nullptr);
    }
}

const CancelToken &stopToken()
{
    return token;
}

int stopSignal()
{
    return firstSignal;
}

int stopDescriptor()
{
    return ends[0];
}

int exitStatusOfStop()
{
    const int signal = stopSignal();
    return shellsBase + (signal == 0 ? SIGINT : signal);
}

} // namespace odo
