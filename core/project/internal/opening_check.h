// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <cstdint>
#include <filesystem>

struct sqlite3;

namespace odo {

class Migrator;
struct ProjectConnection;

/// Looks through a project's file before anything is written to it, for it may come from anyone, and gives
/// the version of its schema: the file holds that schema and nothing else, and all of it is whole, unless it
/// is so large that reading it would take long. The schema comes first, for looking through the rest
/// evaluates the checks in it; all of it is read as it was at one moment. A file made so that looking through
/// it does not end is given up. On the connection's thread. Errors: NewerFormat, InvalidInput (damaged, or
/// not a project's tables), Io where the disk does not give what is in the file.
Result<int> checkContent(ProjectConnection &connection, const Migrator &migrator);

/// While it lives, the statements of a connection may take so many steps of SQLite's virtual machine in all;
/// one that would take more fails with InvalidInput, "the file is damaged". One at a time for a connection,
/// on its thread.
class StepLimit
{
public:
    StepLimit(const ProjectConnection &connection, std::int64_t most);
    ~StepLimit();
    StepLimit(const StepLimit &) = delete;
    StepLimit &operator=(const StepLimit &) = delete;

private:
    static int onSteps(void *limit);

    sqlite3 *const m_handle;
    std::int64_t m_left;
};

/// Looks at the first bytes of a file, without a lock, and says in words why it is no project that can be
/// opened: missing, a folder, empty, another kind of file, another program's database, cut off, or written by
/// a newer Odograph than one that knows `newestVersion`. Says nothing false of a file that another process
/// works on. Never changes anything.
Result<void> checkFileHeader(const std::filesystem::path &file, int newestVersion);

/// Whether the first bytes are those of a project, of any version and however damaged the rest is.
bool isProjectFile(const std::filesystem::path &file);

/// That there is such a file, which could be opened.
Result<void> checkIsFile(const std::filesystem::path &file);

} // namespace odo
