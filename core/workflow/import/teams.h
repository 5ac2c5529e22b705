// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"

#include <filesystem>
#include <string>

namespace odo {

class Project;

/// What a roster brought.
struct RosterOutcome
{
    int added = 0;     ///< teams that are new
    int changed = 0;   ///< teams that have another class, pseudonym or members now
    int unchanged = 0; ///< teams that were as the roster says
};

/// Takes the teams of a roster (readRosterCsv) over: new ones are added, those of the same name get the
/// roster's class, and its pseudonym and members if it has them. One change, which can be undone.
/// InvalidInput, and nothing imported, with every bad line in one sentence with its number. On the project's
/// thread; rosters are short.
Result<RosterOutcome> importRoster(Project &project, const std::filesystem::path &file);

/// The team of that name; when there is none, one of that class is added (empty: of no class). Project's
/// thread.
Result<TeamRecord> findOrAddTeam(Project &project, const std::string &name,
                                 const std::string &className = {});

} // namespace odo
