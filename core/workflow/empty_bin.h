// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

#include <string>
#include <vector>

namespace odo {

class Project;

/// What lies in the bin of a project.
struct BinContent
{
    std::vector<RecordId> trials;
    std::int64_t bytes = 0; ///< of their recordings
};
Result<BinContent> binContent(Project &project);

/// Removes these trials for good, in one transaction, and then those files of their recordings that lie in the project's media
/// folder and belong to no other trial: files elsewhere are somebody's own. Gives the files that could not be deleted. It cannot be
/// undone. InvalidInput, and nothing removed, where one of them is not in the bin any more. On the project's thread.
Result<std::vector<std::string>> emptyBin(Project &project, const BinContent &content);

} // namespace odo
