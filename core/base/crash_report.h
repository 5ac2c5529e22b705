// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace odo {

/// Where what a program leaves for its next start lies: $XDG_STATE_HOME/odograph, or ~/.local/state/odograph.
/// Empty where neither is known.
std::filesystem::path stateFolder();

/// From now on a signal that ends the program by its own fault (SEGV, BUS, ILL, FPE, ABRT, SYS, TRAP) leaves
/// a report in the folder, which is made: version, signal, the open project, and a backtrace. The file is
/// opened beforehand and gets its name in the crash only, so that nothing is left of a run that ends well.
/// Then the signal does what it would have done (a core dump). In the crash only functions are called that
/// are safe in a signal handler (signal-safety(7)), and backtrace, which is loaded beforehand. Once, at the
/// beginning of the program; false where the folder cannot be written to. A stack that is full is reported
/// for the calling thread only. Where memory, threads or files have run out, which libraries answer by such
/// signals, it ends as endForShortage does (also where the folder cannot be written to). Under a sanitizer,
/// which has reports of its own, nothing is watched.
bool watchForCrashes(const std::filesystem::path &folder, const std::string &version);
/// For the report; any thread, one at a time. Cut off after 4000 bytes.
void noteOpenProject(const std::filesystem::path &project);

/// What a crash has left.
struct CrashReport
{
    std::filesystem::path file;
    std::string signal;                           ///< "SIGSEGV"
    std::optional<std::filesystem::path> project; ///< that was open; empty: none
};
/// Those not reported yet, oldest first. Reports no longer than 1 MB are read; nothing else in the
/// folder is.
std::vector<CrashReport> newCrashReports(const std::filesystem::path &folder);
/// It is not new any more: it gets another name, which is given back, and only the newest ten such are kept.
/// The old name where that fails.
std::filesystem::path keepToldReport(const CrashReport &report);

} // namespace odo
