// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_media.h"

#include "core/base/error.h"
#include "core/base/file_system.h"
#include "core/base/plain_text.h"
#include "core/base/platform/file_handle.h"
#include "core/files/file_kind.h"
#include "core/project/internal/opening_check.h"
#include "core/project/project_locks.h"
#include "core/project/project_words.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <set>

namespace odo {

namespace {

Result<void> addImages(Project &project, RecordId camera, ReferredFiles &files)
{
    const auto lenses = ODO_TRY(project.cameras().allIntrinsics(camera));
    for (const IntrinsicsRecord &lens : lenses)
        for (const StoredImage &image : lens.files)
            files.add(project.file(), image.path);
    const auto registrations = ODO_TRY(project.cameras().allRegistrations(camera));
    for (const RegistrationRecord &registration : registrations)
        files.add(project.file(), registration.image.path);
    return {};
}

Result<void> addAllOf(Project &project, ReferredFiles &files)
{
    const auto recordings = ODO_TRY(project.trials().allRecordings());
    for (const RecordingRecord &recording : recordings)
        files.add(project.file(), recording.path);
    const auto cameras = ODO_TRY(project.cameras().all());
    for (const CameraRecord &camera : cameras)
        ODO_TRY(addImages(project, camera.id, files));
    return {};
}

/// No link, device or pipe, which may do anything when it is opened.
bool isOrdinary(const std::filesystem::path &file)
{
    return files::kindOfItself(file) == files::Kind::File;
}

/// The other projects in the folder of one.
std::vector<std::filesystem::path> projectsBeside(const std::filesystem::path &project)
{
    const std::filesystem::path folder = realProjectFile(project).parent_path();
    std::vector<std::filesystem::path> others;
    std::error_code ignored; // it was just read from
    for (const std::string &name : files::namesIn(folder, ignored)) {
        const std::filesystem::path other = folder / name; // whatever its ending is
        if (isOrdinary(other) && isProjectFile(other) && !files::isSame(other, project))
            others.push_back(other);
    }
    return others;
}

/// All that is in the folder and below, links as such.
void addAllBelow(const std::filesystem::path &folder, std::vector<std::filesystem::path> &found,
                 std::error_code &problem)
{
    std::vector<std::string> names = files::namesIn(folder, problem);
    std::ranges::sort(names);
    for (auto name = names.begin(); !problem && name != names.end(); ++name) {
        const std::filesystem::path file = folder / *name;
        const files::Kind kind = files::kindOfItself(file);
        if (kind == files::Kind::Folder)
            addAllBelow(file, found, problem);
        else if (kind != files::Kind::Missing) // gone meanwhile
            found.push_back(file);
    }
}

} // namespace

void ReferredFiles::add(const std::filesystem::path &project, const std::string &path)
{
    if (path.empty())
        return;
    const std::filesystem::path file = absolutePath(project, path);
    m_paths.insert(file);
    if (const auto identity = identityOf(file))
        m_files.insert(*identity);
}

bool ReferredFiles::contains(const std::filesystem::path &file) const
{
    const auto identity = identityOf(file);
    return m_paths.contains(file) || (identity && m_files.contains(*identity));
}

Result<ReferredFiles> filesUsedBeside(const std::filesystem::path &project)
{
    ReferredFiles files;
    for (const std::filesystem::path &beside : projectsBeside(project)) {
        const auto other = Project::openAgain(beside, Project::Access::ReadOnly);
        const Result<void> added = other ? addAllOf(**other, files) : tl::unexpected(other.error());
        if (!added)
            return fail(added.error().code, findStrayFiles(),
                        ODO_TEXT("project.may_be_used_beside",
                                 "project '%1' beside it may use them, and cannot be read (%2)")(
                            Named::file(beside.filename()), added.error().why),
                        ODO_TEXT("project.open_or_move_that",
                                 "open that project, or move it to a folder of its own with its videos"));
    }
    return files;
}

namespace {

/// A recording whose file is not where the project expects it.
struct MissingRecording
{
    std::string fileName, sha256; ///< no hash: it was cut off
    std::int64_t bytes = 0;
};

Result<std::vector<MissingRecording>> missingRecordings(Project &project)
{
    const auto recordings = ODO_TRY(project.trials().allRecordings());
    std::vector<MissingRecording> missing;
    for (const RecordingRecord &recording : recordings) {
        const std::filesystem::path file = project.resolve(recording);
        if (!files::exists(file))
            missing.push_back({file.filename().string(), recording.sha256, recording.bytes});
    }
    return missing;
}

/// By size and content; of one that was cut off nothing but its name is known.
Result<bool> isOneOf(const std::vector<MissingRecording> &missing, const std::filesystem::path &file,
                     const JobControl &control)
{
    std::error_code unknown;
    const auto bytes = static_cast<std::int64_t>(files::sizeOf(file, unknown));
    std::optional<std::string> hash;
    for (const MissingRecording &recording : missing) {
        if (recording.sha256.empty() && recording.fileName == file.filename())
            return true;
        if (unknown || recording.sha256.empty() || recording.bytes != bytes)
            continue;
        if (!hash) {
            auto made = fileSha256(file, control);
            if (!made && made.error().code == ErrorCode::Cancelled)
                return tl::unexpected(made.error());
            hash = made.value_or(std::string());
        }
        if (*hash == recording.sha256)
            return true;
    }
    return false;
}

/// Whether a file is a project's own: what is called like it and more (its log, lock, backups), or lies in
/// its media folder.
bool belongsTo(const std::filesystem::path &project, const std::filesystem::path &file)
{
    const std::filesystem::path media = mediaFolderOf(project);
    return file.string().starts_with(project.string()) || file.string().starts_with(media.string() + '/');
}

/// What neither the program nor a camera makes, by its name and its content.
bool isForeign(const std::filesystem::path &file)
{
    constexpr std::array mediaEndings{".mkv", ".mp4",  ".mov",  ".m4v", ".avi",  ".webm", ".mjpeg",
                                      ".mpg", ".ts",   ".m2ts", ".mts", ".3gp",  ".wmv",  ".png",
                                      ".jpg", ".jpeg", ".bmp",  ".tif", ".tiff", ".part"};
    const std::string ending = lowerCaseAscii(file.extension().string());
    if (std::ranges::find(mediaEndings, ending) != mediaEndings.end())
        return false;
    if (!isOrdinary(file))
        return true;
    const auto handle = FileHandle::openToRead(file, FileHandle::Links::Refused);
    switch (handle ? kindOfFile(*handle).value_or(FileKind::Empty) : FileKind::Empty) {
    case FileKind::Empty:
    case FileKind::Png:
    case FileKind::Jpeg:
    case FileKind::Mp4:
    case FileKind::Matroska:
    case FileKind::Other:
        return false;
    default:
        return true;
    }
}

/// The files that may be stray as far as this project knows.
Result<std::vector<std::filesystem::path>> unusedFiles(Project &project)
{
    const std::filesystem::path media = project.mediaFolder();
    std::vector<std::filesystem::path> files;
    if (files::kindOfItself(mediaFolderOf(project.file())) == files::Kind::Link)
        return files;
    std::error_code problem;
    addAllBelow(media, files, problem);
    if (problem && problem != std::errc::no_such_file_or_directory)
        return cannotSearch(media, problem);
    // Who adds a trial holds its files until it is in the project: checked in this order, none of them is
    // mistaken for a stray one.
    std::erase_if(files, [&](const std::filesystem::path &file) {
        return file.filename() == RecordingLock::fileIn(media).filename() ||
               (isOrdinary(file) && HeldFile::isHeld(file));
    });
    ReferredFiles own;
    ODO_TRY(addAllOf(project, own));
    std::erase_if(files, [&](const std::filesystem::path &file) { return own.contains(file); });
    return files;
}

} // namespace

Result<StrayMedia> strayMedia(Project &project, const JobControl &control)
{
    StrayMedia stray;
    auto files = unusedFiles(project);
    if (!files || files->empty())
        return files.map([&](const auto &) { return stray; });
    const auto beside = ODO_TRY(filesUsedBeside(project.file()));
    std::erase_if(*files, [&](const std::filesystem::path &file) { return beside.contains(file); });
    std::ranges::copy_if(*files, std::back_inserter(stray.projects), [](const std::filesystem::path &file) {
        return isOrdinary(file) && isProjectFile(file);
    });
    std::erase_if(*files, [&](const std::filesystem::path &file) {
        return std::ranges::any_of(
            stray.projects, [&](const std::filesystem::path &other) { return belongsTo(other, file); });
    });
    const auto missing = ODO_TRY(missingRecordings(project));
    for (const std::filesystem::path &file : *files) {
        const auto isLost = ODO_TRY(isOrdinary(file) ? isOneOf(missing, file, control) : Result<bool>(false));
        (isLost ? stray.lost : isForeign(file) ? stray.foreign : stray.files).push_back(file);
    }
    return stray;
}

void addStrayMedia(Project &project, std::vector<ProjectProblem> &problems, const JobControl &control)
{
    const auto stray = strayMedia(project, control);
    if (!stray) {
        problems.push_back(
            {joined({ODO_TEXT("project.strays_unknown", "cannot determine which files belong to no trial"),
                     stray.error().why},
                    Join::Colon),
             stray.error().what, stray.error().advice});
        return;
    }
    const auto addUnused = [&](const std::filesystem::path &file, const MessageText &advice) {
        problems.push_back({ODO_TEXT("project.file_unused",
                                     "no trial, lens calibration or floor registration uses this file"),
                            fileSubject(file), advice});
    };
    for (const std::filesystem::path &file : stray->files)
        addUnused(file, ODO_TEXT("project.adopt_or_remove",
                                 "make a trial of it with odograph check P.odo --adopt, or remove it with "
                                 "--remove-strays; the window offers both under 'Find stray files…'"));
    for (const std::filesystem::path &file : stray->foreign)
        addUnused(file, ODO_TEXT("project.move_file_away", "move it to another folder"));
    for (const std::filesystem::path &file : stray->lost)
        problems.push_back({ODO_TEXT("project.is_missing_recording", "this is a missing recording"),
                            fileSubject(file),
                            ODO_TEXT("project.find_or_put_back",
                                     "take it from there with odograph check P.odo --find FOLDER or Find "
                                     "lost videos… in the window, or move it back to its folder")});
    for (const std::filesystem::path &file : stray->projects)
        problems.push_back(
            {ODO_TEXT("project.lies_in_media", "a project is in the media folder of another one"),
             fileSubject(file),
             ODO_TEXT("project.move_project_away", "move it with its videos to a folder of its own")});
}

Result<bool> removeStray(Project &project, const std::filesystem::path &file)
{
    const auto failed = [&](const std::error_code &reason) {
        return fail(ErrorCode::Io, ODO_TEXT("project.cannot_remove", "cannot remove '%1'")(Named::file(file)),
                    foreignWords(reason.message()),
                    ODO_TEXT("project.check_rights", "check the permissions of the project's folder"));
    };
    FileHandle held;
    if (isOrdinary(file)) {
        auto handle = FileHandle::openToRead(file, FileHandle::Links::Refused);
        if (!handle)
            return handle.error() == std::errc::no_such_file_or_directory ? Result<bool>(false)
                                                                          : failed(handle.error());
        if (handle->tryLock(FileHandle::Lock::Exclusive))
            return false;
        held = std::move(*handle);
    }
    // Now that nobody can adopt it: it may have become a trial's since it was found.
    auto referred = filesUsedBeside(project.file());
    ODO_TRY(referred ? addAllOf(project, *referred) : tl::unexpected(referred.error()));
    if (referred->contains(file))
        return false;
    const std::error_code problem = removeFile(file);
    return problem ? failed(problem) : Result<bool>(true);
}

bool isOwnMedia(const std::filesystem::path &file, const std::filesystem::path &mediaFolder)
{
    std::error_code problem, otherProblem;
    const auto real = files::realPath(file, problem), folder = files::realPath(mediaFolder, otherProblem);
    if (problem || otherProblem)
        return false;
    return std::mismatch(folder.begin(), folder.end(), real.begin(), real.end()).first == folder.end() &&
           real != folder;
}

} // namespace odo
