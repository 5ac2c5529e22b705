// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/shortage.h"

#include "core/base/job_control.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <mutex>
#include <new>
#include <span>
#include <sys/mman.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace odo {

namespace {

Error shortage(std::string what, const char *why)
{
    return {ErrorCode::Unavailable, std::move(what), why, shortageAdvice};
}

bool isCancelledWork()
{
    try {
        throw;
    } catch (const WorkCancelled &) {
        return true;
    } catch (...) {
        return false;
    }
}

std::string wordsOfException()
{
    try {
        throw;
    } catch (const std::exception &problem) {
        return problem.what();
    } catch (...) {
        return "an exception without words";
    }
}

} // namespace

Error noThread(std::string what)
{
    return shortage(std::move(what), "this computer gives no further thread");
}

Error shortageNow(std::string what)
{
    if (isCancelledWork())
        return cancelled(std::move(what)).value();
    if (const char *why = shortageBeingHandled())
        return shortage(std::move(what), why);
    return {ErrorCode::Internal, std::move(what),
            "something unexpected happened (" + wordsOfException() + ")",
            "what was saved is safe; try again, and report it if it happens again"};
}

void sideBySide(std::size_t parts, const std::function<void(std::size_t)> &work)
{
    std::mutex mutex;
    std::exception_ptr thrown;
    const CancelToken *const cancel = CancelScope::current();
    const auto doPart = [&](std::size_t part) {
        const CancelScope scope(cancel);
        try {
            work(part);
        } catch (...) {
            const std::lock_guard lock(mutex);
            thrown = std::current_exception();
        }
    };
    std::vector<std::thread> threads;
    threads.reserve(parts);
    for (std::size_t part = 0; part < parts; ++part) {
        auto thread = startThread({}, [&doPart, part] { doPart(part); });
        if (thread)
            threads.push_back(std::move(*thread));
        else
            doPart(part);
    }
    for (std::thread &thread : threads)
        thread.join();
    if (thrown)
        std::rethrow_exception(thrown);
}

namespace {

constexpr const char *noMemory = "this computer has not enough free memory for it";
constexpr const char *noFiles = "too many files are open";
constexpr const char *noFurtherThread = "this computer gives no further thread";

bool isMemoryThere() noexcept
{
    constexpr std::size_t bytes = 256 << 20; // more than any single request of ours, which is not used
    void *asked = ::mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (asked == MAP_FAILED)
        return false;
    ::munmap(asked, bytes);
    return true;
}

/// As many as a library takes at once.
constexpr std::size_t filesOfALibrary = 8;
constexpr std::size_t mostFilesAsked = 64;

bool canOpenFiles(std::size_t count) noexcept
{
    std::array<int, mostFilesAsked> handles{};
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

void put(const char *text) noexcept
{
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text, std::strlen(text));
}

[[noreturn]] void onUncaught() noexcept
{
    if (const char *why = shortageBeingHandled())
        endForShortage(why);
    try {
        if (std::current_exception())
            throw;
    } catch (const std::exception &problem) {
        put("odograph: something unexpected happened (");
        put(problem.what());
        put(")\n");
    } catch (...) { // has no words
    }
    std::abort();
}

} // namespace

const char *shortageBeingHandled() noexcept
{
    if (!std::current_exception())
        return nullptr;
    try {
        throw;
    } catch (const std::bad_alloc &) {
        return noMemory;
    } catch (const std::system_error &problem) {
        const std::error_code &code = problem.code();
        if (code == std::errc::resource_unavailable_try_again)
            return noFurtherThread;
        if (code == std::errc::too_many_files_open || code == std::errc::too_many_files_open_in_system)
            return noFiles;
        return code == std::errc::not_enough_memory ? noMemory : nullptr;
    } catch (...) {
        return nullptr;
    }
}

void needFiles(std::size_t count) noexcept
{
    if (!canOpenFiles(count))
        endForShortage(noFiles);
}

const char *shortageNowOfSystem() noexcept
{
    return !isMemoryThere()                 ? noMemory
           : !canOpenFiles(filesOfALibrary) ? noFiles
           : !isProcessThere()              ? noFurtherThread
                                            : nullptr;
}

void endForShortage(const char *why) noexcept
{
    put("odograph: ");
    put(cannotDoThis);
    put(": ");
    put(why);
    put("; ");
    put(shortageAdvice);
    put("\n");
    ::_exit(1);
}

void catchWhatNobodyCatches()
{
    std::set_terminate(onUncaught);
}

} // namespace odo
