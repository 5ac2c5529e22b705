// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/relink_job.h"

#include "core/base/file_system.h"
#include "core/project/project.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"

#include <algorithm>
#include <set>

namespace odo {

namespace {

/// Files of one of these sizes, so that only they are read.
Result<std::vector<std::filesystem::path>> filesOfSizes(const std::filesystem::path &folder,
                                                        const std::vector<RecordingRecord> &lost,
                                                        const JobControl &control)
{
    std::vector<std::filesystem::path> files;
    std::error_code problem;
    const auto visit = [&](const std::filesystem::path &file) {
        std::error_code unknown;
        const auto bytes = static_cast<std::int64_t>(files::sizeOf(file, unknown));
        if (!unknown && std::ranges::find(lost, bytes, &RecordingRecord::bytes) != lost.end())
            files.push_back(file);
        return !control.isCancelled();
    };
    files::eachFileBelow(folder, visit, problem);
    if (control.isCancelled())
        return cancelled("look for lost videos");
    if (problem)
        return fail(ErrorCode::Io, "look in '" + folder.string() + "'", problem.message(),
                    "check that the folder is there and may be read");
    return files;
}

} // namespace

Result<void> RelinkJob::prepare(Project &project)
{
    m_project = project.file();
    return {};
}

Result<void> RelinkJob::findLost()
{
    const auto project = Project::openAgain(m_project, Project::Access::ReadOnly);
    if (!project)
        return tl::unexpected(project.error());
    const auto trials = (*project)->trials().names();
    if (!trials)
        return tl::unexpected(trials.error());
    std::set<RecordId> unfinished;
    for (const TrialName &trial : *trials)
        if (trial.unfinished)
            unfinished.insert(trial.id);
    auto recordings = (*project)->trials().allRecordings();
    if (!recordings)
        return tl::unexpected(recordings.error());
    for (RecordingRecord &recording : *recordings)
        if (!unfinished.contains(recording.trial) && !files::exists((*project)->resolve(recording)))
            m_lost.push_back(std::move(recording));
    if (m_lost.empty())
        return fail(ErrorCode::NotFound, "lost videos", "no video of this project is lost",
                    "there is nothing to do");
    return {};
}

Result<void> RelinkJob::run(const JobControl &control)
{
    if (auto found = findLost(); !found)
        return found;
    control.report(0, "looking for files");
    const auto files = filesOfSizes(m_folder, m_lost, control);
    if (!files)
        return tl::unexpected(files.error());
    if (auto looked = look(*files, control); !looked)
        return looked;
    if (m_found.empty())
        return fail(ErrorCode::NotFound, "look in '" + m_folder.string() + "'",
                    m_lost.size() == 1
                        ? "the lost video is not there"
                        : "none of the " + std::to_string(m_lost.size()) + " lost videos is there",
                    "choose the folder where they were copied to");
    return {};
}

Result<void> RelinkJob::look(const std::vector<std::filesystem::path> &files, const JobControl &control)
{
    for (std::size_t i = 0; i < files.size() && m_found.size() < m_lost.size(); ++i) {
        control.report(static_cast<double>(i) / static_cast<double>(files.size()),
                       "reading " + files[i].filename().string());
        const auto hash = fileSha256(files[i], control);
        if (!hash && hash.error().code == ErrorCode::Cancelled)
            return tl::unexpected(hash.error());
        if (!hash)
            continue; // what cannot be read cannot be one of them
        for (const RecordingRecord &lost : m_lost) {
            const bool isKnown = std::ranges::find(m_found, lost.id, &Found::recording) != m_found.end();
            if (!isKnown && lost.sha256 == *hash) // one video may be of several trials
                m_found.push_back({lost.id, files[i]});
        }
    }
    return {};
}

Result<void> RelinkJob::commit(Project &project)
{
    const std::string words =
        m_found.size() == 1 ? "link a lost video" : "link " + std::to_string(m_found.size()) + " lost videos";
    return project.change(words, [&]() -> Result<void> {
        for (const Found &found : m_found) {
            if (auto linked =
                    project.trials().setFile(found.recording, files::absolute(found.file));
                !linked)
                return linked;
        }
        return {};
    });
}

} // namespace odo
