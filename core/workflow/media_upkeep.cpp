// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/media_upkeep.h"

#include "core/base/file_system.h"
#include "core/project/project.h"
#include "core/project/project_media.h"
#include "core/project/project_words.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"
#include "core/video/video_input.h"

#include <algorithm>
#include <map>
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
        return cancelled(ODO_TEXT("workflow.look_for_lost_videos", "search for lost videos"));
    if (problem)
        return cannotSearch(folder, problem);
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
    const auto project = ODO_TRY(Project::openAgain(m_project, Project::Access::ReadOnly));
    const auto trials = ODO_TRY(project->trials().names());
    std::set<RecordId> unfinished;
    for (const TrialName &trial : trials)
        if (trial.unfinished)
            unfinished.insert(trial.id);
    auto recordings = ODO_TRY(project->trials().allRecordings());
    for (RecordingRecord &recording : recordings)
        if (!unfinished.contains(recording.trial) && !files::exists(project->resolve(recording)))
            m_lost.push_back(std::move(recording));
    if (m_lost.empty())
        return fail(ErrorCode::NotFound, ODO_TEXT("workflow.lost_videos", "lost videos"),
                    ODO_TEXT("workflow.no_video_lost", "no video of this project is lost"),
                    ODO_TEXT("workflow.nothing_to_do", "no action is needed"));
    return {};
}

Result<void> RelinkJob::run(const JobControl &control)
{
    ODO_TRY(findLost());
    control.report(0, ODO_TEXT("workflow.looking_for_files", "searching for files"));
    const auto files = ODO_TRY(filesOfSizes(m_folder, m_lost, control));
    ODO_TRY(inspect(files, control));
    if (m_found.empty())
        return fail(
            ErrorCode::NotFound, searchIn(m_folder),
            m_lost.size() == 1
                ? Message(ODO_TEXT("workflow.lost_video_not_there", "the lost video is not in this folder"))
                : ODO_TEXT("workflow.lost_videos_not_there",
                           "none of the %1 lost videos is in this folder")(m_lost.size()),
            ODO_TEXT("workflow.choose_folder_of_copies", "choose the folder where they were copied to"));
    return {};
}

Result<void> RelinkJob::inspect(const std::vector<std::filesystem::path> &files, const JobControl &control)
{
    for (std::size_t i = 0; i < files.size() && m_found.size() < m_lost.size(); ++i) {
        control.report(static_cast<double>(i) / static_cast<double>(files.size()), readingFile(files[i]));
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
    const Message words = m_found.size() == 1
                              ? Message(ODO_TEXT("workflow.link_lost_video", "link a lost video"))
                              : ODO_TEXT("workflow.link_lost_videos", "link %1 lost videos")(m_found.size());
    return project.change(words, [&]() -> Result<void> {
        for (const Found &found : m_found)
            ODO_TRY(project.trials().setFile(found.recording, files::absolute(found.file)));
        return {};
    });
}

namespace {

constexpr const char *cameraOfUnnamed = "A", *inTheMaking = ".part";

/// A stray video by its name, NAME_CAMERA: the camera is the longest of the project's that fits, else what
/// follows the last '_'.
struct StrayView
{
    std::string trial, camera;
};

StrayView viewOf(const std::filesystem::path &file, const std::vector<CameraRecord> &cameras)
{
    const std::string stem = file.stem().string();
    StrayView view{stem, {}};
    for (const CameraRecord &camera : cameras) {
        if (stem.size() > camera.name.size() + 1 && stem.ends_with('_' + camera.name) &&
            camera.name.size() > view.camera.size())
            view = {stem.substr(0, stem.size() - camera.name.size() - 1), camera.name};
    }
    const auto last = stem.rfind('_');
    if (view.camera.empty() && last != std::string::npos && last > 0 && last + 1 < stem.size())
        view = {stem.substr(0, last), stem.substr(last + 1)};
    return view.camera.empty() ? StrayView{stem, cameraOfUnnamed} : view;
}

std::string freeTrialName(const std::string &name, std::set<std::string> &taken)
{
    std::string free = "recovered: " + name;
    for (int number = 2; !taken.insert(free).second; ++number)
        free = "recovered: " + name + " (" + std::to_string(number) + ")";
    return free;
}

} // namespace

Result<void> FindStraysJob::prepare(Project &project)
{
    m_project = project.file();
    return {};
}

Result<void> FindStraysJob::run(const JobControl &control)
{
    control.report(0, ODO_TEXT("workflow.looking_through_media", "searching the media folder"));
    const auto project = ODO_TRY(Project::openAgain(m_project, Project::Access::ReadOnly));
    auto found = ODO_TRY(strayMedia(*project, control));
    m_strays = std::move(found.files);
    for (const auto *some : {&found.foreign, &found.lost, &found.projects})
        m_others.insert(m_others.end(), some->begin(), some->end());
    for (const std::filesystem::path &file : m_strays) {
        if (control.isCancelled())
            return cancelled(findStrayFiles());
        // a link leads to what is somebody else's
        const bool isFile = files::kindOfItself(file) == files::Kind::File;
        if (isFile && file.extension() != inTheMaking && VideoInput::open(file))
            m_videos.push_back(file);
    }
    return {};
}

Result<void> AdoptStraysJob::prepare(Project &project)
{
    const auto cameras = project.cameras().all();
    const auto names = project.trials().names();
    if (!cameras || !names)
        return tl::unexpected(cameras ? names.error() : cameras.error());
    std::set<std::string> taken;
    for (const TrialName &trial : *names)
        taken.insert(trial.name);
    std::map<std::string, std::map<std::string, std::filesystem::path>> videos; // of each trial, by camera
    for (const std::filesystem::path &file : m_videos) {
        const StrayView view = viewOf(file, *cameras);
        if (!videos[view.trial].emplace(view.camera, file).second)
            videos[file.filename().string()].emplace(view.camera, file);
    }
    for (const auto &[name, files] : videos) {
        ImportSettings settings;
        settings.trial = freeTrialName(name, taken);
        settings.videos.assign(files.begin(), files.end());
        auto import = std::make_unique<ImportTrialJob>(std::move(settings));
        ODO_TRY(import->prepare(project));
        m_imports.push_back(std::move(import));
    }
    return {};
}

Result<void> AdoptStraysJob::run(const JobControl &control)
{
    for (std::unique_ptr<ImportTrialJob> &import : m_imports) {
        auto done = import->run(control);
        if (!done && done.error().code == ErrorCode::Cancelled)
            return done;
        if (!done) {
            m_failures.push_back(done.error());
            import.reset();
        }
    }
    return {};
}

Result<void> AdoptStraysJob::commit(Project &project)
{
    for (const std::unique_ptr<ImportTrialJob> &import : m_imports) {
        if (!import)
            continue;
        ODO_TRY(import->commit(project));
        m_trials.push_back(import->trial().name);
    }
    m_imports.clear();
    return {};
}

Result<void> RemoveStraysJob::prepare(Project &project)
{
    m_project = project.file();
    return {};
}

Result<void> RemoveStraysJob::run(const JobControl &control)
{
    const auto project = ODO_TRY(Project::openAgain(m_project, Project::Access::ReadOnly));
    for (const std::filesystem::path &file : m_strays) {
        if (control.isCancelled())
            return cancelled(ODO_TEXT("workflow.remove_strays", "remove stray files"));
        const auto removed = ODO_TRY(removeStray(*project, file));
        if (removed)
            m_removed.push_back(file);
    }
    return {};
}

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
                         paths = ODO_TRY(project.trials().removeForGood(trial.id));
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
