// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/stray_media.h"

#include "core/base/file_system.h"
#include "core/project/file_header.h"
#include "core/project/held_file.h"
#include "core/project/recording_lock.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <set>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace odo {

namespace {

Result<void> addPictures(Project &project, RecordId camera, ReferredFiles &files)
{
    const auto lenses = project.cameras().allIntrinsics(camera);
    if (!lenses)
        return tl::unexpected(lenses.error());
    for (const IntrinsicsRecord &lens : *lenses)
        for (const StoredPicture &picture : lens.files)
            files.add(project.file(), picture.path);
    const auto registrations = project.cameras().allRegistrations(camera);
    if (!registrations)
        return tl::unexpected(registrations.error());
    for (const RegistrationRecord &registration : *registrations)
        files.add(project.file(), registration.picture.path);
    return {};
}

Result<void> addAllOf(Project &project, ReferredFiles &files)
{
    const auto recordings = project.trials().allRecordings();
    if (!recordings)
        return tl::unexpected(recordings.error());
    for (const RecordingRecord &recording : *recordings)
        files.add(project.file(), recording.path);
    const auto cameras = project.cameras().all();
    if (!cameras)
        return tl::unexpected(cameras.error());
    for (const CameraRecord &camera : *cameras) {
        if (auto added = addPictures(project, camera.id, files); !added)
            return added;
    }
    return {};
}

/// The other projects in the folder of one.
std::vector<std::filesystem::path> projectsBeside(const std::filesystem::path &project)
{
    const std::filesystem::path folder = realProjectFile(project).parent_path();
    std::vector<std::filesystem::path> others;
    std::error_code ignored; // it was just read from
    for (const std::string &name : files::namesIn(folder, ignored)) {
        if (std::filesystem::path(name).extension() == ".odo" && isProjectFile(folder / name) && !files::isSame(folder / name, project))
            others.push_back(folder / name);
    }
    return others;
}

/// No link, device or pipe, which may do anything when it is opened.
bool isOrdinary(const std::filesystem::path &file)
{
    return files::kindOfItself(file) == files::Kind::File;
}

/// All that is in the folder and below, links as such.
void addAllBelow(const std::filesystem::path &folder, std::vector<std::filesystem::path> &found, std::error_code &problem)
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
    if (const auto identity = identityOf(absolutePath(project, path)))
        m_files.insert(*identity);
}

bool ReferredFiles::contains(const std::filesystem::path &file) const
{
    const auto identity = identityOf(file);
    return identity && m_files.contains(*identity);
}

Result<ReferredFiles> filesUsedBeside(const std::filesystem::path &project)
{
    ReferredFiles files;
    for (const std::filesystem::path &beside : projectsBeside(project)) {
        const auto other = Project::openAgain(beside, Project::Access::ReadOnly);
        const Result<void> added = other ? addAllOf(**other, files) : tl::unexpected(other.error());
        if (!added)
            return fail(added.error().code, "look for stray files",
                        "project '" + beside.filename().string() + "' beside it may use them, and cannot be read (" + added.error().why + ")",
                        "open that project, or move it to a folder of its own with its videos");
    }
    return files;
}

Result<std::vector<std::filesystem::path>> strayMedia(Project &project)
{
    const std::filesystem::path media = project.mediaFolder();
    std::vector<std::filesystem::path> files;
    std::error_code problem;
    addAllBelow(media, files, problem);
    if (problem && problem != std::errc::no_such_file_or_directory)
        return fail(ErrorCode::Io, "look in '" + media.string() + "'", problem.message(), "check that the folder is there and may be read");
    // Who adds a trial holds its files until it is in the project: looked at in this order, none of them is taken for a stray one.
    std::erase_if(files, [&](const std::filesystem::path &file) {
        return file == RecordingLock::fileIn(media) || (isOrdinary(file) && HeldFile::isHeld(file));
    });
    if (files.empty())
        return files;
    ReferredFiles own;
    if (auto added = addAllOf(project, own); !added)
        return tl::unexpected(added.error());
    std::erase_if(files, [&](const std::filesystem::path &file) { return own.contains(file); });
    if (files.empty())
        return files;
    const auto beside = filesUsedBeside(project.file());
    if (!beside)
        return tl::unexpected(beside.error());
    std::erase_if(files, [&](const std::filesystem::path &file) { return beside->contains(file); });
    return files;
}

void addStrayMedia(Project &project, std::vector<ProjectProblem> &problems)
{
    const auto files = strayMedia(project);
    if (!files) {
        problems.push_back({"it cannot be told which files belong to no trial: " + files.error().why, files.error().what, files.error().advice});
        return;
    }
    for (const std::filesystem::path &file : *files)
        problems.push_back({"no trial, lens calibration or floor registration uses this file", file.string(),
                            "make a trial of it with odograph check P.odo --adopt, or remove it with --remove-strays; the window offers "
                            "both under Find stray files…"});
}

Result<bool> removeStray(Project &project, const std::filesystem::path &file)
{
    const std::string what = "cannot remove '" + file.string() + "'";
    const auto failed = [&](int reason) {
        return fail(ErrorCode::Io, what, std::strerror(reason), "check the rights of the project's folder");
    };
    int descriptor = -1;
    if (isOrdinary(file)) {
        descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
        if (descriptor < 0)
            return errno == ENOENT ? Result<bool>(false) : failed(errno);
        if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
            ::close(descriptor);
            return false;
        }
    }
    // Now that nobody can adopt it: it may have become a trial's since it was found.
    auto referred = filesUsedBeside(project.file());
    const Result<void> added = referred ? addAllOf(project, *referred) : tl::unexpected(referred.error());
    Result<bool> removed = false;
    if (!added)
        removed = tl::unexpected(added.error());
    else if (!referred->contains(file))
        removed = ::unlink(file.c_str()) == 0 ? Result<bool>(true) : failed(errno);
    if (descriptor >= 0)
        ::close(descriptor);
    return removed;
}

} // namespace odo
