// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_words.h"

#include "core/project/internal/words.h"
#include "core/project/names.h"

#include <utility>

namespace odo {

Message copySubject(const std::filesystem::path &copy)
{
    return ODO_TEXT("project.copy", "copy '%1'")(Named::file(copy.filename()));
}

Message undoSubject()
{
    return ODO_TEXT("project.undo", "undo");
}

Message redoSubject()
{
    return ODO_TEXT("project.redo", "redo");
}

Message findStrayFiles()
{
    return ODO_TEXT("project.look_for_strays", "find stray files");
}

Message searchIn(const std::filesystem::path &folder)
{
    return ODO_TEXT("project.look_in", "search '%1'")(Named::file(folder));
}

Message isMissing(Message what)
{
    return ODO_TEXT("project.is_missing", "%1 is missing")(std::move(what));
}

Message recordingWasCutOff()
{
    return ODO_TEXT("project.recording_cut_off", "its recording was cut off");
}

Message readingFile(const std::filesystem::path &file)
{
    return ODO_TEXT("project.reading", "reading %1")(Named::file(file.filename()));
}

tl::unexpected<Error> cannotSearch(const std::filesystem::path &folder, const std::error_code &problem)
{
    return fail(
        ErrorCode::Io, searchIn(folder), foreignWords(problem.message()),
        ODO_TEXT("project.check_folder_is_there", "check that the folder exists and that you may read it"));
}

tl::unexpected<Error> tooManyViews(Message what, std::size_t views)
{
    return fail(ErrorCode::InvalidInput, std::move(what),
                ODO_TEXT("project.has_views", "it has %1 views")(views), useAtMost(mostViews));
}

Message checkProjectFolder()
{
    return ODO_TEXT("project.check_project_folder",
                    "check the free space and the permissions of the project's folder");
}

Message waitUntilThatHasEnded()
{
    return ODO_TEXT("project.wait_until_ended", "wait until that has ended");
}

Message endRecordingFirst()
{
    return ODO_TEXT("project.end_recording_first", "end its recording first");
}

Message restoreAndReopen()
{
    return ODO_TEXT("project.put_back_and_open",
                    "move the file back to its folder, and open the project again");
}

Message trackTrialAgain()
{
    return ODO_TEXT("project.track_again", "track the trial again");
}

} // namespace odo
