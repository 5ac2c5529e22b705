// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/project/project.h"

#include <filesystem>
#include <string>
#include <vector>

namespace odo {

/// A file that the project refers to. name: "the recording of view 'A'".
struct KeptFile
{
    std::filesystem::path file; ///< absolute
    std::string name, sha256;   ///< no hash: it has not been made yet
    std::int64_t bytes = 0;
    std::string adviceWhenMissing;
};

/// Compares the files that a project refers to with what it knows of them: that they are there, their sizes and, withHashes,
/// their content. Each file is read once, however many trials and names it has (hard links too), and each problem is told once.
/// Reports the part of the bytes read. Cancelled.
Result<void> checkFiles(const std::vector<KeptFile> &files, bool withHashes, const JobControl &control, std::vector<ProjectProblem> &problems);

} // namespace odo
