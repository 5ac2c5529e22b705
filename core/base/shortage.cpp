// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/shortage.h"

#include "core/base/cancel_scope.h"
#include "core/base/last_resort.h"

#include <exception>
#include <mutex>
#include <vector>

namespace odo {

namespace {

Error shortage(std::string what, const char *why) { return {ErrorCode::Unavailable, std::move(what), why, shortageAdvice}; }

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
    return {ErrorCode::Internal, std::move(what), "something unexpected happened (" + wordsOfException() + ")",
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

} // namespace odo
