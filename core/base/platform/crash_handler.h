// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace odo {

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

} // namespace odo
