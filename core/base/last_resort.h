// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace odo {

/// What is left to do where memory, threads or open files have run out and nothing else has dealt with it: libraries end the program
/// then, by an exception in one of their threads, by abort() or by a null pointer. It ends with one line and status 1 instead, and no
/// crash is reported, for it is none. Any thread.

/// Within a handler: why this computer could not give what was asked of it; null where another exception is handled.
const char *shortageBeingHandled() noexcept;

/// Asks the system now whether it still gives memory, files and processes: why not, or null. Safe in a signal handler.
const char *shortageNowOfSystem() noexcept;

/// Writes the one line and ends the program with status 1. Nothing is put away, no memory is asked for. Safe in a signal handler.
[[noreturn]] void endForShortage(const char *why) noexcept;

/// Ends it so where not so many more files may be opened, of 64 at most: before a library would tell of it in lines of its own.
void needFiles(std::size_t count) noexcept;

/// From now on a shortage that nobody catches ends the program so. Any other such exception aborts it, as ever, after a line that names
/// it. Once, at the beginning of the program.
void catchWhatNobodyCatches();

} // namespace odo
