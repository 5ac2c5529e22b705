// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/platform/process.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/random.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace odo {

bool openStandardFiles()
{
    const bool isOutputClosed = ::fcntl(STDOUT_FILENO, F_GETFD) < 0;
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(descriptor, F_GETFD) < 0)
            static_cast<void>(::open("/dev/null", O_RDWR)); // the lowest number that is free
    return isOutputClosed;
}

bool isStandardErrorSeen()
{
    return ::isatty(STDERR_FILENO) != 0;
}

void writeToStandardError(const char *text) noexcept
{
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text, std::strlen(text));
}

void treatFileLimitAsError()
{
    std::signal(SIGXFSZ, SIG_IGN);
}

void shareMemoryPools()
{
#ifdef __GLIBC__
    mallopt(M_ARENA_MAX, 2);
#endif
}

bool isMemoryThere() noexcept
{
    constexpr std::size_t bytes = 256 << 20; // more than any single request of ours, which is not used
    void *asked = ::mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (asked == MAP_FAILED)
        return false;
    ::munmap(asked, bytes);
    return true;
}

bool canOpenFiles(std::size_t count) noexcept
{
    constexpr std::size_t mostAsked = 64;
    std::array<int, mostAsked> handles{};
    bool areThere = true;
    const auto wanted = std::span(handles).first(std::min(count, handles.size()));
    for (int &handle : wanted) {
        handle = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
        areThere = areThere && (handle >= 0 || (errno != EMFILE && errno != ENFILE));
    }
    for (const int handle : wanted)
        if (handle >= 0)
            ::close(handle);
    return areThere;
}

bool isProcessThere() noexcept
{
    const pid_t child = ::_Fork();
    if (child == 0)
        ::_exit(0);
    if (child < 0)
        return errno != EAGAIN;
    ::waitpid(child, nullptr, 0);
    return true;
}

Nanoseconds threadCpuTime()
{
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::chrono::seconds(time.tv_sec) + Nanoseconds(time.tv_nsec);
}

std::error_code fillWithRandom(std::span<std::byte> bytes)
{
    return ::getrandom(bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size())
               ? std::error_code()
               : std::error_code(errno, std::generic_category());
}

namespace {

constexpr int shellsBase = 128;

// A signal handler can reach nothing but globals, and may do little more than store to them and write().
const CancelToken &token = *new CancelToken; // never freed: a signal may come while the program is ending
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
