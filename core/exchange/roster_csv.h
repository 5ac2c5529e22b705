// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <string>
#include <vector>

namespace odo {

/// A team of a class, as a roster lists it.
struct RosterEntry
{
    int line = 0; ///< of the file
    std::string className, team;
    std::string pseudonym;                 ///< may be empty
    std::vector<std::string> members = {}; ///< may be empty
};

/// Reads a roster: a CSV file whose header names the columns class and team, and perhaps pseudonym and
/// members (names with semicolons between them), in any order; others (addresses) are not kept. Errors with
/// the file: no such columns, no teams; and every bad line in one sentence with its number: no class, no
/// team, a team that is there twice. Any thread.
Result<std::vector<RosterEntry>> readRosterCsv(const std::filesystem::path &file);

/// The failure of a roster in which lines are wrong: says so of the first ones, and how many there are
/// beside.
tl::unexpected<Error> wrongLines(const std::filesystem::path &roster, std::vector<Message> sentences);

} // namespace odo
