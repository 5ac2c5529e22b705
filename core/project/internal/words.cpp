// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/words.h"

#include "core/project/internal/series_blobs.h"

#include <cstring>
#include <utility>

namespace odo {

Message fileIsDamaged()
{
    return ODO_TEXT("project.file_damaged", "the file is damaged");
}

Message restoreFile()
{
    return ODO_TEXT("project.restore_file", "restore it from a backup copy");
}

Message isNoProject()
{
    return ODO_TEXT("project.not_a_project", "it is not a project file");
}

Message chooseOurFile()
{
    return ODO_TEXT("project.choose_our_file", "choose a file that Odograph has written");
}

Message isOfNewerFormat(std::int64_t version, int newestKnown)
{
    return ODO_TEXT("project.newer_format",
                    "it was written by a newer Odograph (format %1, this one knows formats up to %2)")(
        version, newestKnown);
}

Message openWithThatOdograph()
{
    return ODO_TEXT("project.open_with_that_odograph", "open it with that version, or update this one");
}

Message openWithNewerOdograph()
{
    return ODO_TEXT("project.open_with_newer_odograph", "open the project with a newer Odograph");
}

Message cannotBeWrittenTo()
{
    return ODO_TEXT("project.cannot_be_written_to", "it cannot be written to");
}

Message copyToWritableFolder()
{
    return ODO_TEXT("project.copy_to_writable_folder",
                    "copy it to a folder that you may write to, and open the copy");
}

Message anotherProgramWrites()
{
    return ODO_TEXT("project.another_program_writes", "another program is writing to it");
}

Message closeOtherProgram()
{
    return ODO_TEXT("project.close_other_program", "close the other program and try again");
}

Message diskCannotBeRead()
{
    return ODO_TEXT("project.disk_unreadable", "the disk could not be read; nothing was changed");
}

Message copyToAnotherDisk()
{
    return ODO_TEXT("project.copy_to_another_disk", "check the disk, and copy the project to another one");
}

Message writingFailed(const std::error_code &reason)
{
    return ODO_TEXT("project.writing_failed", "writing it failed (%1)")(foreignWords(reason.message()));
}

Message checkDiskAndRetry()
{
    return ODO_TEXT("project.check_disk_and_retry", "check the disk and try again");
}

Message isDamagedRestoreFile()
{
    return joined({ODO_TEXT("project.project_file_damaged", "the project file is damaged"), restoreFile()},
                  Join::Colon);
}

Message restoreProject()
{
    return ODO_TEXT("project.restore_project", "restore the project from a backup copy");
}

Message hasTooManySamples()
{
    return ODO_TEXT("project.too_many_samples", "it has more than %1 samples")(maxBlobRows);
}

Message useAtMost(std::size_t count)
{
    return ODO_TEXT("project.use_at_most", "use at most %1")(count);
}

Message returnFile()
{
    return ODO_TEXT("project.put_file_back", "move the file back to its folder");
}

Message keepIt()
{
    return ODO_TEXT("project.keep_it", "keep it");
}

Message projectCheck()
{
    return ODO_TEXT("project.check", "check of the project");
}

Message runProjectCheck()
{
    return ODO_TEXT("project.run_check", "run a check of the project");
}

tl::unexpected<Error> unknownStoredWord(const std::string &word, const Message &what)
{
    return fail(ErrorCode::NewerFormat, what,
                ODO_TEXT("project.unknown_setting", "its stored setting '%1' is unknown")(word),
                openWithNewerOdograph());
}

} // namespace odo
