// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/import/teams.h"

#include "core/base/error.h"
#include "core/exchange/roster_csv.h"
#include "core/project/project.h"
#include "core/project/repositories.h"

#include <map>

namespace odo {

namespace {

Result<void> store(Project &project, const RosterEntry &entry, const std::map<std::string, TeamRecord> &known,
                   RosterOutcome &outcome)
{
    const auto same = known.find(entry.team);
    if (same == known.end()) {
        ++outcome.added;
        return withoutValue(
            project.teams().add({0, entry.team, entry.className, entry.pseudonym, entry.members}));
    }
    TeamRecord team = same->second;
    const std::string pseudonym = entry.pseudonym.empty() ? team.pseudonym : entry.pseudonym;
    const std::vector<std::string> members = entry.members.empty() ? team.members : entry.members;
    const bool isSame =
        team.className == entry.className && team.pseudonym == pseudonym && team.members == members;
    ++(isSame ? outcome.unchanged : outcome.changed);
    if (isSame)
        return {};
    team.className = entry.className;
    team.pseudonym = pseudonym;
    team.members = members;
    return project.teams().set(team);
}

} // namespace

Result<RosterOutcome> importRoster(Project &project, const std::filesystem::path &file)
{
    const auto entries = ODO_TRY(readRosterCsv(file));
    const auto teams = ODO_TRY(project.teams().all());
    std::map<std::string, TeamRecord> known;
    for (const TeamRecord &team : teams)
        known.emplace(team.name, team);
    RosterOutcome outcome;
    const MessageArgument name = Named::file(file.filename());
    const auto done = project.change(
        ODO_TEXT("workflow.import_roster", "import the roster %1")(name), [&]() -> Result<void> {
            std::vector<Message> bad;
            for (const RosterEntry &entry : entries)
                if (const auto stored = store(project, entry, known, outcome); !stored)
                    bad.push_back(joined({ODO_TEXT("workflow.roster_line", "line %1")(entry.line),
                                          stored.error().what, stored.error().why},
                                         Join::Colon));
            if (bad.empty())
                return {};
            return wrongLines(file, std::move(bad));
        });
    if (!done)
        return tl::unexpected(done.error());
    return outcome;
}

Result<TeamRecord> findOrAddTeam(Project &project, const std::string &name, const std::string &className)
{
    auto found = project.teams().find(name);
    if (found || found.error().code != ErrorCode::NotFound)
        return found;
    return project.teams().add({0, name, className});
}

} // namespace odo
