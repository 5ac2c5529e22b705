// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/teams.h"

#include "core/project/project.h"
#include "core/project/repositories.h"

namespace odo {

Result<TeamRecord> findOrAddTeam(Project &project, const std::string &name)
{
    auto found = project.teams().find(name);
    if (found || found.error().code != ErrorCode::NotFound)
        return found;
    return project.teams().add({0, name, ""});
}

} // namespace odo
