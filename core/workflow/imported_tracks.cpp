// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/imported_tracks.h"

#include "core/project/project.h"
#include "core/project/repositories.h"

namespace odo {

Result<std::vector<ImportedTrack>> importedTracksOf(Project &project, const TrialRecord &trial)
{
    std::vector<ImportedTrack> tracks;
    for (const RecordId robot : trial.robots) {
        auto track = project.trials().currentImportedTrack(trial.id, robot, false);
        if (!track)
            return tl::unexpected(track.error());
        if (*track)
            tracks.push_back(std::move(**track));
    }
    return tracks;
}

} // namespace odo
