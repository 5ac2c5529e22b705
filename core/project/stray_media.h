// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/protected_files.h"
#include "core/project/project.h"

#include <filesystem>
#include <set>
#include <vector>

namespace odo {

/// The files that projects refer to, as far as they are there; by what they are, not by their names, which a file system may spell in
/// several ways.
class ReferredFiles
{
public:
    /// path: as a project stores it.
    void add(const std::filesystem::path &project, const std::string &path);
    bool contains(const std::filesystem::path &file) const;

private:
    std::set<FileIdentity> m_files;
};

/// What the other projects in the folder of a project refer to: a copy of a project uses the first one's media. Error where one of them cannot
/// be read, so that nobody can tell.
Result<ReferredFiles> filesUsedBeside(const std::filesystem::path &project);

/// The files in a project's media folder that no recording, lens calibration or floor registration refers to, of this project and of those
/// beside it (a copy of a project uses the first one's files), by whatever name or link: what a killed program left, or a person put there. In the order of their names. Without what a living program is writing
/// (ClaimedFile). Looks at the disk. Errors: those of the repositories; Io where the folder cannot be read.
Result<std::vector<std::filesystem::path>> strayMedia(Project &project);

/// For Project::check: a problem for each, or why it cannot be told.
void addStrayMedia(Project &project, std::vector<ProjectProblem> &problems);

/// Removes a stray file. False, and it stays, where it is none, or a living program is writing it. Error Io.
Result<bool> removeStray(Project &project, const std::filesystem::path &file);

} // namespace odo
