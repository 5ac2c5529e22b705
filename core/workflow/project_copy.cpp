// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/project_copy.h"

#include "core/base/error.h"
#include "core/base/file_system.h"
#include "core/exchange/project_archive.h"
#include "core/files/output_file.h"
#include "core/files/temporary.h"
#include "core/project/names.h"
#include "core/project/new_file.h"
#include "core/project/project.h"
#include "core/project/project_media.h"
#include "core/project/project_words.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"
#include "core/video/video_input.h"

#include <map>
#include <set>

namespace odo {

namespace {

Message copyingProject()
{
    return ODO_TEXT("workflow.copying_project", "copying the project");
}

} // namespace

Result<void> CopyJob::prepare(Project &project)
{
    m_project = project.file();
    return {};
}

Result<void> CopyJob::run(const JobControl &control)
{
    const Message what = copySubject(m_copy);
    ODO_TRY(checkNewProject(m_copy, what));
    control.report(0, copyingProject());
    const auto project = ODO_TRY(Project::openAgain(m_project, Project::Access::ReadOnly));
    ODO_TRY(project->saveCopy(m_copy));
    if (!control.isCancelled())
        return {};
    files::remove(m_copy);
    return cancelled(what);
}

namespace {

/// Locks and files in the making belong to nobody.
bool belongs(const std::filesystem::path &file)
{
    return file.extension() != ".lock" && file.extension() != ".part";
}

void addFilesBelow(const std::filesystem::path &folder, const std::filesystem::path &media,
                   std::vector<std::filesystem::path> &files, std::error_code &problem)
{
    const std::vector<std::string> names = files::namesIn(folder, problem);
    for (auto name = names.begin(); !problem && name != names.end(); ++name) {
        const std::filesystem::path file = folder / *name;
        if (files::kindOfItself(file) == files::Kind::Folder)
            addFilesBelow(file, media, files, problem);
        else if (files::isFile(file) && belongs(file) && isOwnMedia(file, media))
            files.push_back(file);
    }
}

/// All that belongs to a project's media; none where there is no folder. Links that lead out of it are left.
/// A folder that cannot be read is an error, for what lies in it would be missing.
Result<std::vector<std::filesystem::path>> filesIn(const std::filesystem::path &folder)
{
    std::vector<std::filesystem::path> files;
    std::error_code problem;
    addFilesBelow(folder, folder, files, problem);
    if (problem && problem != std::errc::no_such_file_or_directory)
        return cannotPack(folder, foreignWords(problem.message()));
    return files;
}

/// Whether a file from elsewhere is the video that the recording was made of. A project may come from anyone
/// and name any file of whoever packs it.
Result<bool> isItsVideo(const std::filesystem::path &file, const RecordingRecord &recording,
                        const JobControl &control)
{
    std::error_code problem;
    const auto bytes = files::sizeOf(file, problem);
    if (problem || bytes != static_cast<std::uintmax_t>(recording.bytes))
        return false;
    if (recording.sha256.empty())
        return VideoInput::open(file).has_value();
    return fileSha256(file, control).map([&](const std::string &sha256) {
        return sha256 == recording.sha256;
    });
}

std::string freeName(const std::filesystem::path &file, std::set<std::string> &taken)
{
    std::string name = file.filename().string();
    for (int number = 2; !taken.insert(name).second; ++number)
        name = file.stem().string() + "_" + std::to_string(number) + file.extension().string();
    return name;
}

} // namespace

Result<void> PackJob::prepare(Project &project)
{
    m_project = realProjectFile(project.file()); // whose name its media folder has
    m_mediaFolder = project.mediaFolder();
    return checkOutput(m_archive, FileKind::Zip).map([](const OutputLocation &) {});
}

/// Which videos come from elsewhere, and which are lost or replaced.
Result<void> PackJob::inspect(Project &project, const JobControl &control)
{
    const auto trials = ODO_TRY(project.trials().names());
    std::map<RecordId, std::string> names;
    for (const TrialName &trial : trials) {
        if (trial.unfinished)
            return fail(ErrorCode::InvalidInput, packSubject(m_project.filename()),
                        ODO_TEXT("workflow.trial_being_recorded",
                                 "trial '%1' is being recorded")(Named::trial(trial.name)),
                        endRecordingFirst());
        names.emplace(trial.id, trial.name);
    }
    const auto recordings = ODO_TRY(project.trials().allRecordings());
    for (const RecordingRecord &recording : recordings) {
        const std::filesystem::path file = project.resolve(recording);
        const std::string &trial = names[recording.trial];
        if (!files::exists(file)) {
            m_warnings.push_back(
                ODO_TEXT("workflow.lost_not_packed",
                         "the video of camera %1 in trial '%2' is lost and is not in the packed project")(
                    Named::camera(recording.cameraName), Named::trial(trial)));
        } else if (!isOwnMedia(file, m_mediaFolder)) {
            const auto isIts = ODO_TRY(isItsVideo(file, recording, control));
            if (isIts) {
                m_elsewhere.push_back({recording.id, file});
                m_inputs.add(file);
            } else {
                m_warnings.push_back(
                    ODO_TEXT("workflow.replaced_not_packed",
                             "the video of camera %1 in trial '%2' is outside the media folder and has "
                             "changed since; it is not in the packed project")(
                        Named::camera(recording.cameraName), Named::trial(trial)));
            }
        }
    }
    return {};
}

/// A copy whose recordings all lie in its media folder; notes them as entries.
Result<void> PackJob::copyProject(const std::filesystem::path &copy, std::vector<ArchiveEntry> &entries,
                                  const JobControl &control)
{
    {
        const auto original = ODO_TRY(Project::openAgain(m_project, Project::Access::ReadOnly));
        ODO_TRY(inspect(*original, control));
        ODO_TRY(original->saveCopy(copy));
    }
    entries.push_back({m_project.filename().string(), copy});
    const std::string media = m_mediaFolder.filename().string() + "/";
    const auto files = ODO_TRY(filesIn(m_mediaFolder));
    std::set<std::string> taken;
    for (const std::filesystem::path &file : files) {
        const std::string name = file.lexically_relative(m_mediaFolder).generic_string();
        taken.insert(name);
        entries.push_back({media + name, file});
    }
    if (m_elsewhere.empty())
        return {};
    const auto project = ODO_TRY(Project::open(copy, Project::Access::ReadWrite));
    for (const Elsewhere &each : m_elsewhere) {
        const std::string name = media + freeName(each.file, taken);
        entries.push_back({name, each.file});
        ODO_TRY(project->trials().setFile(each.recording, copy.parent_path() / name));
    }
    return {};
}

Result<void> PackJob::run(const JobControl &control)
{
    // Beside the archive: that disk needs the space anyway.
    const auto work = ODO_TRY(TemporaryFolder::make(files::absolute(m_archive.file).parent_path(),
                                                    quotedFileSubject(m_archive.file)));
    const std::filesystem::path copy = work->path() / m_project.filename();
    std::vector<ArchiveEntry> entries;
    control.report(0, copyingProject());
    ODO_TRY(copyProject(copy, entries, control));
    return writeArchive(m_archive, entries, control);
}

namespace {

template <class Record, class Take>
Result<void> takeAll(const Result<std::vector<Record>> &records, const Take &take)
{
    if (!records)
        return tl::unexpected(records.error());
    for (const Record &record : *records)
        ODO_TRY(take(record));
    return {};
}

/// Without the images of its calibration.
Result<void> takeIntrinsics(Project &from, RecordId camera, Project &to, RecordId newCamera)
{
    auto intrinsics = from.cameras().currentIntrinsics(camera);
    if (!intrinsics || !*intrinsics)
        return intrinsics ? Result<void>() : tl::unexpected(intrinsics.error());
    IntrinsicsRecord taken = **intrinsics;
    taken.camera = newCamera;
    taken.files.clear();
    return withoutValue(to.cameras().addIntrinsics(taken));
}

Result<void> takeSetUp(Project &from, Project &to, const JobControl &control)
{
    const auto camera = [&](const CameraRecord &record) -> Result<void> {
        if (control.isCancelled())
            return cancelled(ODO_TEXT("workflow.new_project", "new project"));
        const auto added = to.cameras().add(record);
        return added ? takeIntrinsics(from, record.id, to, added->id) : tl::unexpected(added.error());
    };
    const auto layout = [&](const LayoutRecord &record) {
        return withoutValue(to.layouts().add(record.layout));
    };
    const auto robot = [&](const RobotRecord &record) { return withoutValue(to.robots().add(record)); };
    const auto task = [&](const TaskRecord &record) -> Result<void> {
        const auto scoring = from.tasks().scoring(record.id);
        const auto added = to.tasks().add(record);
        if (!scoring || !added)
            return tl::unexpected(scoring ? added.error() : scoring.error());
        return scoring->empty() ? Result<void>() : to.tasks().setScoring(added->id, *scoring);
    };
    ODO_TRY(takeAll(from.cameras().all(), camera));
    ODO_TRY(takeAll(from.layouts().all(), layout));
    ODO_TRY(takeAll(from.robots().all(), robot));
    return takeAll(from.tasks().current(), task);
}

/// In place of the empty file that is there. Closed it is one file, with everything in it.
Result<void> makeFilled(Project &from, const std::filesystem::path &file, const std::string &title,
                        const JobControl &control)
{
    files::remove(file);
    const auto original = ODO_TRY(from.title());
    const auto to = ODO_TRY(Project::create(file, title));
    return to->note(ODO_TEXT("workflow.take_over_set_up", "copy the set-up of %1")(original),
                    [&] { return takeSetUp(from, *to, control); });
}

} // namespace

Result<std::filesystem::path> makeProjectLike(const std::filesystem::path &original,
                                              const std::filesystem::path &file, const std::string &title,
                                              const JobControl &control)
{
    control.report(0, ODO_TEXT("workflow.taking_over_set_up", "copying the set-up"));
    const auto from = ODO_TRY(Project::openAgain(original, Project::Access::ReadOnly));
    const Message what = projectSubject(file);
    ODO_TRY(checkNewProject(file, what));
    NewFile made(file, what);
    ODO_TRY(made.prepare());
    ODO_TRY(makeFilled(*from, made.temporary(), title, control));
    ODO_TRY(made.publish());
    return file;
}

} // namespace odo
