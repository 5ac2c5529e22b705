// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/import/track_of_robot.h"

#include "core/base/error.h"
#include "core/exchange/track_export.h"
#include "core/workflow/shared_words.h"

namespace odo {

Result<FileTrack> trackOfRobot(TrackFile file, const std::string &robot, const std::filesystem::path &path)
{
    if (file.tracks.size() == 1)
        return std::move(file.tracks.front());
    std::vector<std::string> names;
    for (FileTrack &track : file.tracks) {
        if (track.name == robot || track.name == trackerName(robot))
            return std::move(track);
        names.push_back(track.name);
    }
    return fail(ErrorCode::NotFound, quotedFileSubject(path),
                ODO_TEXT("workflow.no_track_of_that_name", "none of its tracks is called '%1'; it has %2")(
                    Named::robot(robot), quotedNames(names, MessageArgument::Kind::Label)),
                ODO_TEXT("workflow.name_robot_after_track", "give the robot the name of one of them"));
}

} // namespace odo
