// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/base/units.h"

#include <cstddef>
#include <span>
#include <system_error>

/// What the program asks of the system besides files.

namespace odo {

/// Opens those of the three standard files that are closed on nothing: what is opened next would get their
/// number, and all that is printed. Whether standard output was closed. Once, at the beginning of the
/// program.
bool openStandardFiles();
/// Whether a person sees what is written to standard error. Any thread.
bool isStandardErrorSeen();
/// Writes to standard error as it is; what fails is lost. Safe in a signal handler. Any thread.
void writeToStandardError(const char *text) noexcept;

/// From now on a file that may not grow is an error like a full disk, not the end of the program. Once, at
/// the beginning of the program.
void treatFileLimitAsError();

/// Has all threads of this program take their memory from two of the C library's pools (glibc's arenas)
/// instead of up to eight for each processor. One thread allocates frames and another frees them:
/// each pool then keeps what it once held: thirty trials in a row grew the program from 110 MB to 310 MB,
/// with two pools it stays at 150. Call it first in main().
void shareMemoryPools();

/// Whether the system still gives so much memory as any single request of ours takes, so many more files (64
/// at most are asked for), and a process. Safe in a signal handler. Any thread.
bool isMemoryThere() noexcept;
bool canOpenFiles(std::size_t count) noexcept;
bool isProcessThere() noexcept;

/// The processor's time that the calling thread has taken. Never fails.
Nanoseconds threadCpuTime();

/// Fills it with what nobody can foresee; the system's reason where it has no random numbers. Any thread.
std::error_code fillWithRandom(std::span<std::byte> bytes);

/// From now on SIGINT (Ctrl-C), SIGTERM and SIGHUP ask this program to stop in good order: each cancels the
/// token and makes the descriptor readable. A second SIGINT ends it at once. SIGHUP stays ignored where it
/// was (nohup). Once, at the start.
void watchStopSignals();

/// Cancelled by the first of them. Any thread.
const CancelToken &stopToken();
/// Which came first, SIGINT before the others; 0: none. Any thread.
int stopSignal();
/// Becomes readable once one came; nobody reads from it. -1: the system gave none.
int stopDescriptor();

/// The exit status of a program that was asked to stop, as a shell reports it: 130 of Ctrl-C, or where no
/// signal came; 143 of SIGTERM, 129 of SIGHUP.
int exitStatusOfStop();

} // namespace odo
