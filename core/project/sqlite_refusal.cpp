// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/sqlite_refusal.h"

#include "core/base/last_resort.h"
#include "core/base/shortage.h"

#include <cerrno>
#include <sqlite3.h>

namespace odo {

namespace {

/// SQLite asks for files and memory and tells of neither.
SqliteRefusal unlessShort(const SqliteRefusal &reason)
{
    const char *shortage = shortageNowOfSystem();
    return shortage ? SqliteRefusal{ErrorCode::Unavailable, shortage, shortageAdvice} : reason;
}

} // namespace

SqliteRefusal sqliteRefusal(int resultCode, int systemError)
{
    constexpr SqliteRefusal unknown{ErrorCode::Internal, "the database refused", "run a check of the project"};
    constexpr SqliteRefusal full{ErrorCode::Io, "the disk is full, the change was not saved", "make room on the disk and try again"};
    switch (resultCode & 0xff) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
    case SQLITE_PROTOCOL: // it came too often between others that lock
        return {ErrorCode::Io, "another program is writing to it", "close the other program and try again"};
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_AUTH:
        return {ErrorCode::ReadOnly, "it cannot be written to",
                "copy it to a folder that you may write to, and open the copy"};
    case SQLITE_CANTOPEN:
        return unlessShort({ErrorCode::ReadOnly, "its folder cannot be written to", "copy it to a folder that you may write to, and open the copy"});
    case SQLITE_FULL:
        return full;
    case SQLITE_IOERR:
        if (systemError == ENOSPC || systemError == EDQUOT || systemError == EFBIG)
            return full;
        if (systemError == EROFS)
            return {ErrorCode::Io, "the disk has become read-only, the change was not saved",
                    "check the disk, and copy the project to another one"};
        if (resultCode == SQLITE_IOERR_READ || resultCode == SQLITE_IOERR_CORRUPTFS) // what EIO is to it
            return {ErrorCode::Io, "the disk could not be read, and nothing was changed",
                    "check the disk, and copy the project to another one"};
        return unlessShort({ErrorCode::Io, "the disk reported an error, the change was not saved",
                            "check the disk, and copy the project to another one"});
    case SQLITE_NOMEM:
    case SQLITE_OK: // Qt failed by itself
        return unlessShort(unknown);
    case SQLITE_CORRUPT:
    case SQLITE_INTERRUPT: // by a StepLimit
        return {ErrorCode::InvalidInput, "the file is damaged", "restore it from a backup copy"};
    case SQLITE_NOTADB:
        return {ErrorCode::InvalidInput, "it is not a project file",
                "choose a file that Odograph has written"};
    case SQLITE_CONSTRAINT:
        return {ErrorCode::InvalidInput,
                "it refers to something that is not in the project, or a value is missing",
                "add what it refers to first"};
    case SQLITE_TOOBIG:
        return {ErrorCode::InvalidInput, "a value is too large to be stored",
                "split the recording into shorter ones"};
    default:
        return unknown;
    }
}

} // namespace odo
