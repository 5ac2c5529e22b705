// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/files/output_file.h"

#include <filesystem>
#include <string>
#include <vector>

namespace odo {

/// A project in one file: a ZIP archive with `<name>.odo` and everything beside it in `<name>.media/`, which
/// any system can open. Videos are stored as they are, the project is deflated (libarchive).

/// A file that goes into an archive, under this name there.
struct ArchiveEntry
{
    std::string name;
    std::filesystem::path file;
};

/// Writes an archive as an OutputFile. Any thread; long. Errors: those of OutputFile; Io with the file at
/// fault, Cancelled; nothing is left behind then.
Result<void> writeArchive(const OutputTarget &archive, const std::vector<ArchiveEntry> &entries,
                          const JobControl &control);

/// What errors of packing are about, and the Io of a file or folder that cannot be read.
Message packSubject(const std::filesystem::path &file);
tl::unexpected<Error> cannotPack(const std::filesystem::path &file, Message why);

/// Unpacks an archive into a new folder and gives the path of the project in it. Whatever would leave the
/// folder, and whatever is neither the project nor in its media folder, is refused: an archive may come from
/// anyone. Any thread; long. Errors: AlreadyExists where the folder is; InvalidInput for what is no such
/// archive; Io; Cancelled; nothing is left behind then.
Result<std::filesystem::path> unpackArchive(const std::filesystem::path &archive,
                                            const std::filesystem::path &folder, const JobControl &control);

} // namespace odo
