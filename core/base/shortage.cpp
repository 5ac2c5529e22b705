// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/shortage.h"

#include "core/base/cancel_scope.h"

#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <vector>

namespace odo {

namespace {

constexpr const char *advice = "what was saved is safe; close other programs and try again";

Error noMemory(std::string what)
{
    return {ErrorCode::Unavailable, std::move(what), "this computer has not enough free memory for it", advice};
}

} // namespace

Error noThread(std::string what)
{
    return {ErrorCode::Unavailable, std::move(what), "this computer gives no further thread", advice};
}

Error shortageNow(std::string what)
{
    try {
        throw;
    } catch (const WorkCancelled &) {
        return cancelled(std::move(what)).value();
    } catch (const std::bad_alloc &) {
        return noMemory(std::move(what));
    } catch (const std::system_error &problem) {
        if (problem.code() == std::errc::resource_unavailable_try_again)
            return noThread(std::move(what));
        if (problem.code() == std::errc::too_many_files_open ||
            problem.code() == std::errc::too_many_files_open_in_system)
            return {ErrorCode::Unavailable, std::move(what), "too many files are open", advice};
        if (problem.code() == std::errc::not_enough_memory)
            return noMemory(std::move(what));
        throw;
    }
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
