// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace odo {

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
std::filesystem::path keepShownReport(const CrashReport &report);

} // namespace odo
