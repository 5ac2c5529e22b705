// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <cstddef>
#include <functional>
#include <thread>
#include <type_traits>

namespace odo {

/// What to do when this computer has run out of memory, threads or open files: the standard library throws,
/// and here that becomes an Error, code Unavailable, before it can end the program. Any thread.

/// Its messages, available without allocating.
const MessageText &cannotDoThis() noexcept; ///< subject of a job that ends by a shortage
const MessageText &closeOtherPrograms() noexcept;
const MessageText &noFurtherThread() noexcept; ///< a reason of it

/// That what was saved is safe, and to close other programs.
Message shortageAdvice();

/// Within a handler: the Error of a shortage that is being handled, or of any other exception, code Internal,
/// with its own words.
Error shortageNow(Message what);

/// Reports that no thread is available, where something other than the standard library found out.
Error noThread(Message what);

/// Does work that gives a Result; an exception in it is its Error. what: the Message that says what could not
/// be done, or, for work on each frame, a function that gives it.
template <class What, class Work>
std::invoke_result_t<Work &> orShortage(const What &what, Work &&work)
{
    try {
        return work();
    } catch (...) {
        if constexpr (std::is_invocable_r_v<Message, const What &>)
            return tl::unexpected(shortageNow(what()));
        else
            return tl::unexpected(shortageNow(what));
    }
}

/// A new thread that does the work, or why there is none. What the work throws ends the program
/// (last_resort.h).
template <class Work>
Result<std::thread> startThread(const Message &what, Work &&work)
{
    return orShortage(what, [&]() -> Result<std::thread> { return std::thread(std::forward<Work>(work)); });
}

/// Does the work of each of so many parts in parallel, on as many threads as are available; on the
/// caller's where there are none. Returns when all are done; what one of them threw is thrown on here.
void sideBySide(std::size_t parts, const std::function<void(std::size_t)> &work);

/// What is left to do where memory, threads or open files have run out and nothing else has dealt with it:
/// libraries end the program then, by an exception in one of their threads, by abort() or by a null pointer.
/// It ends with one line and status 1 instead, and no crash is reported, for it is none. Any thread.

/// Within a handler: why this computer could not give what was asked of it; null where another exception is
/// handled.
const MessageText *shortageBeingHandled() noexcept;

/// Asks the system now whether it still gives memory, files and processes: why not, or null. Safe in a signal
/// handler.
const MessageText *shortageNowOfSystem() noexcept;

/// Writes the one line and ends the program with status 1. Nothing is put away, no memory is asked for. Safe
/// in a signal handler.
[[noreturn]] void endForShortage(const MessageText &why) noexcept;

/// Ends it so where not so many more files may be opened, of 64 at most: before a library would report it in
/// lines of its own.
void needFiles(std::size_t count) noexcept;

/// From now on a shortage that nobody catches ends the program so. Any other such exception aborts it, as
/// ever, after a line that names it. Once, at the beginning of the program.
void catchWhatNobodyCatches();

} // namespace odo
