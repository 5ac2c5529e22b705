// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/platform/crash_handler.h"

#include "core/base/file_system.h"
#include "core/base/shortage.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstring>
#include <ctime>
#include <execinfo.h>
#include <fcntl.h>
#include <unistd.h>

namespace odo {

// All that the handler uses is made beforehand and never freed.

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool isSanitized = true;
#else
constexpr bool isSanitized = false;
#endif

struct NamedSignal
{
    int number;
    const char *name;
};
constexpr NamedSignal signals[] = {{SIGSEGV, "SIGSEGV"}, {SIGBUS, "SIGBUS"},   {SIGILL, "SIGILL"},
                                   {SIGFPE, "SIGFPE"},   {SIGABRT, "SIGABRT"}, {SIGSYS, "SIGSYS"},
                                   {SIGTRAP, "SIGTRAP"}}; // how GLib aborts

constexpr int mostFrames = 100;
constexpr std::size_t longestText = 4096;

/// The handler's own memory.
struct Prepared
{
    std::array<char, longestText> head{};    ///< "odograph 0.1.0 ended unexpectedly\nbegun: …"
    std::array<char, longestText> file{};    ///< the report's name
    std::array<char, 64> unnamed{};          ///< of the file that is open, in /proc
    std::array<char, longestText> project{}; ///< that is open
    std::atomic<std::size_t> projectLength = 0;
    std::array<void *, mostFrames> frames{};
    int descriptor = -1; ///< of a file without a name yet; -1: to be made
};
Prepared prepared;
std::atomic_flag isCrashing = ATOMIC_FLAG_INIT;
alignas(16) std::array<char, 128 * 1024> handlerStack;

void put(int descriptor, const char *text, std::size_t length)
{
    while (length > 0) {
        const ssize_t written = ::write(descriptor, text, length);
        if (written <= 0)
            return;
        text += written;
        length -= static_cast<std::size_t>(written);
    }
}

void put(int descriptor, const char *text)
{
    put(descriptor, text, std::strlen(text));
}

void putHex(int descriptor, std::uintptr_t value)
{
    char digits[2 + 2 * sizeof value] = {'0', 'x'};
    for (std::size_t i = 0; i < 2 * sizeof value; ++i)
        digits[2 + i] = "0123456789abcdef"[value >> (4 * (2 * sizeof value - 1 - i)) & 0xf];
    put(descriptor, digits, sizeof digits);
}

const char *nameOf(int signal)
{
    for (const NamedSignal &each : signals)
        if (each.number == signal)
            return each.name;
    return "unknown";
}

void writeReport(int descriptor, int signal, const siginfo_t *information)
{
    put(descriptor, prepared.head.data());
    if (const std::size_t length = prepared.projectLength.load(); length > 0) {
        put(descriptor, "project: ");
        put(descriptor, prepared.project.data(), length);
        put(descriptor, "\n");
    }
    put(descriptor, "signal: ");
    put(descriptor, nameOf(signal));
    put(descriptor, "\naddress: ");
    putHex(descriptor, reinterpret_cast<std::uintptr_t>(information->si_addr));
    put(descriptor, "\n\n");
    const int count = ::backtrace(prepared.frames.data(), mostFrames);
    ::backtrace_symbols_fd(prepared.frames.data(), count, descriptor);
}

void onCrash(int signal, siginfo_t *information, void *)
{
    if (isCrashing.test_and_set()) // a second thread, or a crash in here: the first one ends the program
        for (;;)
            ::pause();
    ::alarm(10); // whatever hangs in here
    if (const MessageText *why = shortageNowOfSystem())
        endForShortage(*why);
    int descriptor = prepared.descriptor;
    const bool isUnnamed = descriptor >= 0;
    if (!isUnnamed)
        descriptor = ::open(prepared.file.data(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (descriptor >= 0) {
        writeReport(descriptor, signal, information);
        ::fsync(descriptor);
        if (isUnnamed)
            ::linkat(AT_FDCWD, prepared.unnamed.data(), AT_FDCWD, prepared.file.data(), AT_SYMLINK_FOLLOW);
    }
    struct sigaction usual = {};
    usual.sa_handler = SIG_DFL;
    ::sigaction(signal, &usual, nullptr);
    ::raise(signal); // delivered when this returns, for until then it is blocked
}

template <std::size_t size>
bool copyTo(std::array<char, size> &to, const std::string &text)
{
    if (text.size() >= size)
        return false;
    std::copy(text.c_str(), text.c_str() + text.size() + 1, to.begin());
    return true;
}

void handle()
{
    stack_t stack = {};
    stack.ss_sp = handlerStack.data();
    stack.ss_size = handlerStack.size();
    ::sigaltstack(&stack, nullptr);
    struct sigaction action = {};
    action.sa_sigaction = onCrash;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK;
    for (const NamedSignal &signal : signals)
        ::sigaction(signal.number, &action, nullptr);
}

} // namespace

bool watchForCrashes(const std::filesystem::path &folder, const std::string &version)
{
    if (isSanitized)
        return false;
    ::backtrace(prepared.frames.data(), 1); // loads what it needs
    handle();
    std::error_code problem;
    files::makeFolders(folder, problem);
    if (problem || folder.empty() || ::access(folder.c_str(), W_OK) != 0)
        return false;
    const std::time_t now = std::time(nullptr);
    std::array<char, 32> stamp{};
    std::tm parts{};
    std::strftime(stamp.data(), stamp.size(), "%Y%m%dT%H%M%SZ", ::gmtime_r(&now, &parts));
    const std::string name = "crash-" + std::string(stamp.data()) + "-" + std::to_string(::getpid()) + ".txt";
    if (!copyTo(prepared.file, (folder / name).string()) ||
        !copyTo(prepared.head, "odograph " + version + " ended unexpectedly\nbegun: " + stamp.data() + "\n"))
        return false;
    // not on every file system
    prepared.descriptor = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
    copyTo(prepared.unnamed, "/proc/self/fd/" + std::to_string(prepared.descriptor));
    return true;
}

void noteOpenProject(const std::filesystem::path &project)
{
    const std::string path = project.string();
    const std::size_t length = std::min<std::size_t>(path.size(), 4000);
    prepared.projectLength = 0;
    std::copy(path.data(), path.data() + length, prepared.project.begin());
    prepared.projectLength = path.find('\n') == std::string::npos ? length : 0;
}

} // namespace odo
