// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/file_words.h"

namespace odo {

Message cannotBeRead(std::string because)
{
    return ODO_TEXT("files.cannot_be_read", "it cannot be read (%1)")(foreignWords(std::move(because)));
}

Message cannotBeWritten(std::string because)
{
    return ODO_TEXT("files.cannot_be_written", "it cannot be written (%1)")(foreignWords(std::move(because)));
}

tl::unexpected<Error> cannotBeInspected(Message what, const std::error_code &problem, Message advice)
{
    return fail(
        ErrorCode::Io, std::move(what),
        ODO_TEXT("files.cannot_be_looked_at", "it cannot be accessed (%1)")(foreignWords(problem.message())),
        std::move(advice));
}

Message cannotBeRead()
{
    return ODO_TEXT("files.unreadable", "it cannot be read");
}

Message cannotWriteFile(const std::filesystem::path &file)
{
    return ODO_TEXT("files.cannot_write", "cannot write '%1'")(Named::file(file));
}

tl::unexpected<Error> nameIsTooLong(Message what)
{
    return fail(ErrorCode::InvalidInput, std::move(what),
                ODO_TEXT("files.name_too_long", "its name is too long"),
                ODO_TEXT("files.choose_shorter_name", "choose a shorter name"));
}

Message fileIsEmpty()
{
    return ODO_TEXT("files.file_is_empty", "the file is empty");
}

Message noSuchFile()
{
    return ODO_TEXT("files.no_such_file", "the file does not exist");
}

Message noSuchFolder(const std::filesystem::path &folder)
{
    return ODO_TEXT("files.no_such_folder", "folder '%1' does not exist")(Named::file(folder));
}

Message isThereAlready()
{
    return ODO_TEXT("files.is_there_already", "it already exists");
}

Message nameAFile()
{
    return ODO_TEXT("files.name_a_file", "give a file name");
}

Message chooseAnotherName()
{
    return ODO_TEXT("files.choose_another_name", "choose another name");
}

Message chooseAnotherNameOrFolder()
{
    return ODO_TEXT("files.choose_name_or_folder", "choose another name or folder");
}

Message chooseFolderWithSpace()
{
    return ODO_TEXT("files.choose_folder_with_room",
                    "choose a folder that you may write to and that has free space");
}

Message chooseWritableFolder()
{
    return ODO_TEXT("files.choose_writable_folder", "choose a folder that you may write to");
}

Message freeDiskSpace()
{
    return ODO_TEXT("files.make_room", "free some disk space and try again");
}

Message checkItsFolder()
{
    return ODO_TEXT("files.check_its_folder", "check the free space and the permissions of its folder");
}

Message makeFolderFirst()
{
    return ODO_TEXT("files.make_folder_first", "create the folder first, or choose another one");
}

Message checkFileMayBeRead()
{
    return ODO_TEXT("files.check_may_be_read", "check that you may read the file");
}

Message checkFileIsThere()
{
    return ODO_TEXT("files.check_file_is_there", "check that the file exists and that you may read it");
}

} // namespace odo
