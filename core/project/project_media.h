// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/protected_files.h"
#include "core/project/project.h"

#include <filesystem>
#include <set>
#include <vector>

namespace odo {

/// The files that projects refer to: by what they are, for a file system may spell a name in several ways,
/// and by their paths, for a link may lead to a disk that is not there.
class ReferredFiles
{
public:
    /// path: as a project stores it.
    void add(const std::filesystem::path &project, const std::string &path);
    bool contains(const std::filesystem::path &file) const;

private:
    std::set<FileIdentity> m_files;
    std::set<std::filesystem::path> m_paths;
};

/// What the other projects in the folder of a project refer to: a copy of a project uses the first one's
/// media. Error where one of them cannot be read: then it is not known.
Result<ReferredFiles> filesUsedBeside(const std::filesystem::path &project);

/// What lies in a project's media folder and no recording, lens calibration or floor registration refers to,
/// of this project and of those beside it (a copy of a project uses the first one's files), by whatever name
/// or link: what a killed program left, or a person put there. In the order of their names.
struct StrayMedia
{
    std::vector<std::filesystem::path> files;
    /// Likewise, but what neither the program nor a camera makes: texts, documents, links. They are named,
    /// and left where they are.
    std::vector<std::filesystem::path> foreign;
    /// None of these is stray: missing recordings, by their content, under another name or in another folder
    /// than the project expects.
    std::vector<std::filesystem::path> lost;
    /// Nor these: other projects, which do not belong in a media folder. What belongs to them is left out.
    std::vector<std::filesystem::path> projects;
};
/// Without what a living program is writing (ClaimedFile). Nothing where the media folder is a link: others
/// may use what lies there. Looks at the disk, and reads files of the size of missing recordings. Errors:
/// those of the repositories; Io where the folder cannot be read; Cancelled.
Result<StrayMedia> strayMedia(Project &project, const JobControl &control = {});

/// For Project::check: a problem for each, or why that is not known.
void addStrayMedia(Project &project, std::vector<ProjectProblem> &problems, const JobControl &control);

/// Removes a stray file that strayMedia has found. False, and it stays, where it has become a trial's since,
/// or a living program is writing it. Error Io.
Result<bool> removeStray(Project &project, const std::filesystem::path &file);

/// Whether a file lies in a project's media folder, all links followed. What a project names outside of it
/// belongs to somebody else and is never removed: a project may come from anyone. Looks at the disk; any
/// thread.
bool isOwnMedia(const std::filesystem::path &file, const std::filesystem::path &mediaFolder);

} // namespace odo
