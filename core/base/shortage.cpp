// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/shortage.h"

#include "core/base/job_control.h"
#include "core/base/platform/process.h"

#include <cstdlib>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <vector>

namespace odo {

const MessageText &cannotDoThis() noexcept
{
    return ODO_TEXT("base.cannot_do_this", "cannot do this");
}

const MessageText &closeOtherPrograms() noexcept
{
    return ODO_TEXT("base.close_other_programs", "close other programs and try again");
}

const MessageText &noFurtherThread() noexcept
{
    return ODO_TEXT("base.no_thread", "this computer cannot start another thread");
}

namespace {

const MessageText &savedIsSafe() noexcept
{
    return ODO_TEXT("base.saved_is_safe", "what was saved is safe");
}

Error shortage(Message what, const MessageText &why)
{
    return {ErrorCode::Unavailable, std::move(what), why, shortageAdvice()};
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

Message wordsOfException()
{
    try {
        throw;
    } catch (const std::exception &problem) {
        return foreignWords(problem.what());
    } catch (...) {
        return ODO_TEXT("base.wordless_exception", "an unknown exception");
    }
}

} // namespace

Message shortageAdvice()
{
    return joined({savedIsSafe(), closeOtherPrograms()}, Join::Semicolon);
}

Error noThread(Message what)
{
    return shortage(std::move(what), noFurtherThread());
}

Error shortageNow(Message what)
{
    if (isCancelledWork())
        return cancelled(std::move(what)).value();
    if (const MessageText *why = shortageBeingHandled())
        return shortage(std::move(what), *why);
    return {ErrorCode::Internal, std::move(what),
            ODO_TEXT("base.unexpected", "something unexpected happened (%1)")(wordsOfException()),
            joined({savedIsSafe(),
                    ODO_TEXT("base.try_again_and_report", "try again, and report it if it happens again")},
                   Join::Semicolon)};
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

const MessageText &noMemory() noexcept
{
    return ODO_TEXT("base.no_memory", "this computer does not have enough free memory for it");
}

const MessageText &noFiles() noexcept
{
    return ODO_TEXT("base.no_files", "too many files are open");
}

/// As many as a library takes at once.
constexpr std::size_t filesOfALibrary = 8;

[[noreturn]] void onUncaught() noexcept
{
    if (const MessageText *why = shortageBeingHandled())
        endForShortage(*why);
    try {
        if (std::current_exception())
            throw;
    } catch (const std::exception &problem) {
        writeToStandardError("odograph: something unexpected happened (");
        writeToStandardError(problem.what());
        writeToStandardError(")\n");
    } catch (...) { // has no words
    }
    std::abort();
}

} // namespace

const MessageText *shortageBeingHandled() noexcept
{
    if (!std::current_exception())
        return nullptr;
    try {
        throw;
    } catch (const std::bad_alloc &) {
        return &noMemory();
    } catch (const std::system_error &problem) {
        const std::error_code &code = problem.code();
        if (code == std::errc::resource_unavailable_try_again)
            return &noFurtherThread();
        if (code == std::errc::too_many_files_open || code == std::errc::too_many_files_open_in_system)
            return &noFiles();
        return code == std::errc::not_enough_memory ? &noMemory() : nullptr;
    } catch (...) {
        return nullptr;
    }
}

void needFiles(std::size_t count) noexcept
{
    if (!canOpenFiles(count))
        endForShortage(noFiles());
}

const MessageText *shortageNowOfSystem() noexcept
{
    return !isMemoryThere()                 ? &noMemory()
           : !canOpenFiles(filesOfALibrary) ? &noFiles()
           : !isProcessThere()              ? &noFurtherThread()
                                            : nullptr;
}

void endForShortage(const MessageText &why) noexcept
{
    writeToStandardError("odograph: ");
    writeToStandardError(cannotDoThis().english);
    writeToStandardError(": ");
    writeToStandardError(why.english);
    writeToStandardError("; ");
    writeToStandardError(savedIsSafe().english);
    writeToStandardError("; ");
    writeToStandardError(closeOtherPrograms().english);
    writeToStandardError("\n");
    std::_Exit(1);
}

void catchWhatNobodyCatches()
{
    std::set_terminate(onUncaught);
}

} // namespace odo
