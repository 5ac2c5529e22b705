// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_rescue.h"

#include "core/base/file_system.h"
#include "core/base/platform/user_folders.h"
#include "core/files/output_file.h"
#include "core/files/temporary.h"
#include "core/project/internal/connection.h"
#include "core/project/internal/opening_check.h"
#include "core/project/internal/schema.h"
#include "core/project/internal/words.h"
#include "core/project/names.h"
#include "core/project/project.h"
#include "core/project/recording_rows.h"
#include "core/project/write_ahead_log.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

namespace odo {

namespace {

/// "3" and "3.2" of "lesson.odo.bak-3.2": not what is being made beside them.
bool isBackupNumber(std::string_view text)
{
    return !text.empty() && text.find_first_not_of("0123456789.") == std::string_view::npos;
}

bool isSound(const std::filesystem::path &backup)
{
    if (!checkFileHeader(backup, projectMigrator().newestVersion()))
        return false;
    const auto connection = ProjectConnection::open(backup, DatabaseAccess::Immutable);
    if (!connection)
        return false;
    return passesQuickCheck(**connection).value_or(false);
}

} // namespace

std::filesystem::path backupFolderOf(const std::filesystem::path &project)
{
    const std::filesystem::path real = realProjectFile(project);
    return real.parent_path() / (real.stem().string() + ".backups");
}

std::vector<std::filesystem::path> backupFilesOf(const std::filesystem::path &project)
{
    const std::string start = project.filename().string() + ".bak-",
                      realStart = realProjectFile(project).filename().string() + ".bak-";
    std::vector<std::pair<std::filesystem::file_time_type, std::filesystem::path>> backups;
    const auto collect = [&backups](const std::filesystem::path &folder, const std::string &beginning) {
        std::error_code problem;
        for (const std::string &name : files::namesIn(folder, problem)) {
            if (!name.starts_with(beginning) ||
                !isBackupNumber(std::string_view(name).substr(beginning.size())))
                continue;
            const auto written = files::lastWritten(folder / name, problem);
            if (!problem)
                backups.emplace_back(written, folder / name);
        }
    };
    collect(project.has_parent_path() ? project.parent_path() : std::filesystem::path("."), start);
    collect(backupFolderOf(project), realStart);
    std::ranges::sort(backups, std::greater());
    std::vector<std::filesystem::path> files;
    for (auto &backup : backups)
        files.push_back(std::move(backup.second));
    return files;
}

std::optional<std::filesystem::path> soundBackupOf(const std::filesystem::path &project)
{
    const std::vector<std::filesystem::path> backups = backupFilesOf(project);
    const auto sound = std::ranges::find_if(backups, &isSound);
    return sound == backups.end() ? std::nullopt : std::optional(*sound);
}

Result<void> worthOpening(const std::filesystem::path &project)
{
    auto header = checkFileHeader(project, projectMigrator().newestVersion());
    if (!header && header.error().code == ErrorCode::InvalidInput && soundBackupOf(project))
        return {};
    return header;
}

Message adviceToCopy(const std::filesystem::path &backup)
{
    return ODO_TEXT("project.copy_sound_backup",
                    "copy '%1', which is intact, to a new name, open that copy and keep the damaged file")(
        Named::file(backup.filename()));
}

Error namingABackup(Error error, const std::filesystem::path &project)
{
    if (error.code != ErrorCode::InvalidInput)
        return error;
    if (const auto backup = soundBackupOf(project))
        error.advice = adviceToCopy(*backup);
    return error;
}

namespace {

bool isThere(const std::filesystem::path &file)
{
    return files::kindOfItself(file) != files::Kind::Missing;
}

std::filesystem::path freeName(const std::filesystem::path &first)
{
    const auto isFree = [](const std::filesystem::path &name) {
        return !isThere(name) && std::ranges::none_of(sideFileSuffixes, [&name](const char *side) {
            return isThere(besideFile(name, side));
        });
    };
    std::filesystem::path name = first;
    for (int i = 2; !isFree(name); ++i)
        name = besideFile(first, '.' + std::to_string(i));
    return name;
}

std::error_code renamed(const std::filesystem::path &from, const std::filesystem::path &to)
{
    std::error_code problem;
    files::rename(from, to, problem);
    return problem;
}

/// Gives a project and the files beside it a second name, and removes it unless keep() is called.
class KeptAside
{
public:
    KeptAside(std::filesystem::path project, std::filesystem::path kept)
        : m_project(std::move(project)), m_kept(std::move(kept))
    {
    }
    KeptAside(const KeptAside &) = delete;
    KeptAside &operator=(const KeptAside &) = delete;
    ~KeptAside()
    {
        for (const auto &[from, to] : m_moved)
            static_cast<void>(renamed(to, from));
        if (m_isLinked)
            static_cast<void>(removeFile(m_kept));
    }

    const std::filesystem::path &kept() const { return m_kept; }
    /// Why the system refuses.
    std::error_code take()
    {
        // A link leaves the file under its name until another replaces it. Not every disk (a USB stick's FAT)
        // knows links.
        std::error_code problem;
        files::link(m_project, m_kept, problem);
        m_isLinked = !problem;
        for (const char *side : sideFileSuffixes) {
            if (!isThere(besideFile(m_project, side)))
                continue;
            problem = move(besideFile(m_project, side), besideFile(m_kept, side));
            if (problem)
                return problem;
        }
        return m_isLinked ? std::error_code() : move(m_project, m_kept);
    }
    void keep()
    {
        m_moved.clear();
        m_isLinked = false;
    }

private:
    std::error_code move(const std::filesystem::path &from, const std::filesystem::path &to)
    {
        const std::error_code problem = renamed(from, to);
        if (!problem)
            m_moved.emplace_back(from, to);
        return problem;
    }

    const std::filesystem::path m_project, m_kept;
    std::vector<std::pair<std::filesystem::path, std::filesystem::path>> m_moved;
    bool m_isLinked = false;
};

} // namespace

ReplacingCopy::ReplacingCopy(std::filesystem::path project, Message advice,
                             std::unique_ptr<TemporaryFolder> folder)
    : m_project(std::move(project)), m_advice(std::move(advice)), m_folder(std::move(folder))
{
}

ReplacingCopy::~ReplacingCopy() = default;

std::filesystem::path ReplacingCopy::file() const
{
    return m_folder->path() / m_project.filename();
}

Result<std::unique_ptr<ReplacingCopy>> ReplacingCopy::make(const std::filesystem::path &backup,
                                                           const std::filesystem::path &project)
{
    const Message what = projectSubject(project.filename()), advice = adviceToCopy(backup);
    const std::filesystem::path real = realProjectFile(project); // a link stays one
    auto folder = TemporaryFolder::make(real.parent_path(), what);
    if (!folder)
        return fail(folder.error().code, what, folder.error().why, advice);
    std::unique_ptr<ReplacingCopy> copy(new ReplacingCopy(real, advice, std::move(*folder)));
    const auto source = ProjectConnection::open(backup, DatabaseAccess::Immutable);
    if (!source)
        return fail(source.error().code, what, source.error().why, advice);
    if (auto copied = copyDatabase(**source, copy->file()); !copied)
        return fail(copied.error().code, what, copied.error().why, advice);
    return copy;
}

Result<void> ReplacingCopy::replaceProject(const std::filesystem::path &kept)
{
    const auto refused = [this](const std::error_code &problem) {
        return fail(ErrorCode::Io, projectSubject(m_project.filename()), writingFailed(problem), m_advice);
    };
    KeptAside aside(m_project, kept);
    if (const std::error_code problem = aside.take())
        return refused(problem);
    syncToDisk(
        m_project.parent_path()); // some file systems cannot sync a folder: both files are safe already
    if (const std::error_code problem = renamed(file(), m_project))
        return refused(problem);
    aside.keep();
    syncToDisk(m_project.parent_path());
    return {};
}

Result<RestoredBackup> restoreBackup(const std::filesystem::path &project)
{
    const auto backup = soundBackupOf(project);
    if (!backup)
        return fail(ErrorCode::NotFound, projectSubject(project.filename()),
                    ODO_TEXT("project.no_sound_backup", "no intact backup was found beside it"),
                    restoreFile());
    const std::filesystem::path kept = freeName(besideFile(realProjectFile(project), ".damaged"));
    const auto copy = ODO_TRY(ReplacingCopy::make(*backup, project));
    ODO_TRY(copy->replaceProject(kept));
    return RestoredBackup{*backup, kept};
}

namespace {

/// The folders to try, in this order.
std::vector<std::filesystem::path> foldersFor(const Project &project)
{
    std::vector<std::filesystem::path> folders;
    const auto add = [&](const std::filesystem::path &folder) {
        if (files::isFolder(folder))
            folders.push_back(folder);
    };
    add(files::absolute(project.file()).parent_path());
    if (const auto now = project.currentLocation())
        add(now->parent_path());
    add(homeFolder());
    return folders;
}

} // namespace

Result<std::filesystem::path> rescueProject(const Project &project)
{
    constexpr int mostNames = 1000;
    project.emptyLog(); // or whoever opens a file that replaced this one would apply the log to that
    const Message what = projectSubject(project.file().filename());
    Result<void> done = fail(ErrorCode::NotFound, what,
                             ODO_TEXT("project.no_place_to_rescue_to",
                                      "its folder is gone, and no home folder exists to rescue it to"),
                             returnFile());
    for (const std::filesystem::path &folder : foldersFor(project)) {
        for (int number = 1; number <= mostNames; ++number) {
            const std::string ending =
                number == 1 ? " (rescued).odo" : " (rescued " + std::to_string(number) + ").odo";
            const std::filesystem::path file = folder / (project.file().stem().string() + ending);
            done = checkNewProject(file, what);
            if (done)
                done = project.saveCopy(file);
            if (done)
                return file;
            if (done.error().code != ErrorCode::AlreadyExists)
                break;
        }
    }
    return tl::unexpected(done.error());
}

namespace {

constexpr std::array<std::string_view, 14> networkFileSystems = {
    "nfs",         "nfs4",       "cifs",
    "smb3",        "smbfs",      "afs",
    "ceph",        "fuse.sshfs", "fuse.gvfsd-fuse",
    "fuse.rclone", "fuse.davfs", "fuse.glusterfs",
    "fuse.s3fs",   "davfs"};

struct SyncProgram
{
    /// folder: how its name begins; mark: a file or folder in it, may be empty
    std::string_view name, folder, mark;
};
constexpr std::array<SyncProgram, 8> syncPrograms = {{
    {"Dropbox", "Dropbox", ".dropbox.cache"},
    {"OneDrive", "OneDrive", ""},
    {"Nextcloud", "Nextcloud", ".nextcloudsync.log"},
    {"ownCloud", "ownCloud", ".owncloudsync.log"},
    {"Google Drive", "Google Drive", ""},
    {"Google Drive", "GoogleDrive", ""},
    {"iCloud", "iCloudDrive", ""},
    {"Syncthing", "", ".stfolder"},
}};

/// Spaces in the list of mounts are written as \040.
std::string withSpaces(const std::string &text)
{
    constexpr std::string_view escaped = "\\040";
    std::string plain;
    std::size_t begin = 0;
    for (auto at = text.find(escaped); at != std::string::npos; at = text.find(escaped, begin)) {
        plain += text.substr(begin, at - begin) + ' ';
        begin = at + escaped.size();
    }
    return plain + text.substr(begin);
}

std::optional<std::string_view> syncProgramOf(const std::filesystem::path &folder)
{
    for (std::filesystem::path each = folder; each.has_relative_path(); each = each.parent_path()) {
        for (const SyncProgram &program : syncPrograms) {
            const bool isNamedSo =
                !program.folder.empty() && each.filename().string().starts_with(program.folder);
            if (isNamedSo || (!program.mark.empty() && files::exists(each / program.mark)))
                return program.name;
        }
    }
    return std::nullopt;
}

} // namespace

std::string fileSystemOf(const std::filesystem::path &file, const std::string &mounts)
{
    std::istringstream lines(mounts);
    std::string line, kind;
    std::size_t longest = 0;
    while (std::getline(lines, line)) {
        std::istringstream words(line);
        std::string device, location, name;
        words >> device >> location >> name;
        const std::filesystem::path mounted = withSpaces(location);
        const auto [rest, ignored] = std::mismatch(mounted.begin(), mounted.end(), file.begin(), file.end());
        // the last one of a mount point counts
        if (rest == mounted.end() && mounted.native().size() >= longest && !name.empty()) {
            longest = mounted.native().size();
            kind = name;
        }
    }
    return kind;
}

std::optional<Message> locationWarning(const std::filesystem::path &project)
{
    std::ifstream stream("/proc/self/mounts");
    return locationWarning(project, {std::istreambuf_iterator<char>(stream), {}});
}

std::optional<Message> locationWarning(const std::filesystem::path &project, const std::string &mounts)
{
    const std::filesystem::path file = files::realPath(project);
    const auto warning = [&](Message why) {
        return wholeMessage(projectSubject(project.filename()), std::move(why),
                            ODO_TEXT("project.keep_on_own_disk",
                                     "keep it on a disk of this computer, and pack it to share it"));
    };
    const std::string kind = fileSystemOf(file, mounts);
    if (std::ranges::find(networkFileSystems, kind) != networkFileSystems.end())
        return warning(ODO_TEXT(
            "project.on_network_disk",
            "it is on a network disk (%1): a recording can stall there, and two computers can damage it")(
            kind));
    if (const auto program = syncProgramOf(file.parent_path()))
        return warning(
            ODO_TEXT("project.in_synced_folder",
                     "it is in a folder that %1 copies while it changes: a copy may contain half a change")(
                std::string(*program)));
    return std::nullopt;
}

} // namespace odo
