// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/empty_bin.h"

#include "core/base/file_system.h"
#include "core/project/project.h"
#include "core/project/project_media.h"
#include "core/project/repositories.h"

namespace odo {

Result<BinContent> binContent(Project &project)
{
    auto names = project.trials().names();
    const auto bytes = project.trials().binnedBytes();
    if (!names || !bytes)
        return tl::unexpected(names ? bytes.error() : names.error());
    std::erase_if(*names, [](const TrialName &name) { return !name.binned; });
    return BinContent{std::move(*names), *bytes};
}

Result<void> EmptyBinJob::prepare(Project &project)
{
    m_file = project.file();
    return {};
}

Result<void> EmptyBinJob::run(const JobControl &control)
{
    const auto project = ODO_TRY(Project::openAgain(m_file, Project::Access::ReadWrite));
    const auto usedBeside = filesUsedBeside(m_file);
    for (std::size_t i = 0; i < m_content.trials.size() && !control.isCancelled(); ++i) {
        const TrialName &trial = m_content.trials[i];
        control.report(static_cast<double>(i) / static_cast<double>(m_content.trials.size()),
                       ODO_TEXT("workflow.removing", "removing %1")(Named::trial(trial.name)));
        ODO_TRY(remove(*project, trial, usedBeside));
    }
    return {};
}

/// usedBeside: by other projects, as far as known.
Result<void> EmptyBinJob::remove(Project &project, const TrialName &trial,
                                 const Result<ReferredFiles> &usedBeside)
{
    const auto known = project.trials().get(trial.id);
    if (!known && known.error().code != ErrorCode::NotFound)
        return tl::unexpected(known.error());
    if (!known || !known->binned) // another window has removed it or restored it from the bin
        return {};
    std::vector<std::string> paths;
    auto removed =
        project.note(ODO_TEXT("workflow.remove_for_good", "remove %1 for good")(Named::trial(trial.name)),
                     [&]() -> Result<void> {
                         auto files = ODO_TRY(project.trials().removeForGood(trial.id));
                         paths = std::move(files);
                         return {};
                     });
    if (!removed)
        return removed;
    ++m_removed;
    for (const std::string &path : paths) {
        RecordingRecord recording;
        recording.path = path;
        const std::filesystem::path file = project.resolve(recording);
        const auto used = project.trials().isFileUsed(path);
        if (used.value_or(false) || !isOwnMedia(file, project.mediaFolder()) ||
            (usedBeside && usedBeside->contains(file)))
            continue;
        const bool isKnown = used && usedBeside;
        std::error_code problem;
        if (isKnown)
            files::remove(file, problem);
        if (!isKnown || problem) // what may be in use stays, and is reported
            m_left.push_back(file.string());
    }
    return {};
}

Result<void> EmptyBinJob::commit(Project &)
{
    return {};
}

} // namespace odo
