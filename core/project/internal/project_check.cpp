// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/project_check.h"

#include "core/base/error.h"
#include "core/base/file_system.h"
#include "core/base/job_control.h"
#include "core/base/shortage.h"
#include "core/base/units.h"
#include "core/files/protected_files.h"
#include "core/project/internal/analysis_check.h"
#include "core/project/internal/connection.h"
#include "core/project/internal/task_repository.h"
#include "core/project/limits.h"
#include "core/project/project.h"
#include "core/project/project_locks.h"
#include "core/project/project_media.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"

#include <cerrno>
#include <condition_variable>
#include <cstring>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <sqlite3.h>
#include <string>
#include <sys/stat.h>
#include <utility>
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

namespace {

struct FileOnDisk
{
    FileIdentity id;
    std::int64_t bytes = 0;
};

/// NotFound where there is nothing, Io where the system does not say, InvalidInput where something else is in
/// its place.
Result<FileOnDisk> onDisk(const std::filesystem::path &file)
{
    const std::string what = "file '" + file.string() + "'";
    struct stat status = {};
    if (stat(file.c_str(), &status) != 0) {
        const bool isMissing = errno == ENOENT || errno == ENOTDIR;
        return fail(isMissing ? ErrorCode::NotFound : ErrorCode::Io, what,
                    std::string("it cannot be read (") + std::strerror(errno) + ")",
                    "check that the file is there and may be read");
    }
    if (!S_ISREG(status.st_mode))
        return fail(ErrorCode::InvalidInput, what, "it is a folder or a device, not a file",
                    "put the original file back in its place");
    return FileOnDisk{{status.st_dev, status.st_ino}, status.st_size};
}

class FileCheck
{
public:
    FileCheck(const JobControl &control, std::vector<ProjectProblem> &problems)
        : m_control(control), m_problems(problems)
    {
    }

    /// Looks whether the files are there, and remembers those whose content is to be looked at.
    Result<void> compareSizes(const std::vector<KeptFile> &files)
    {
        for (const KeptFile &kept : files) {
            if (m_control.isCancelled())
                return cancelled("check of the project");
            auto known = m_onDisk.find(kept.file);
            if (known == m_onDisk.end())
                known = m_onDisk.emplace(kept.file, onDisk(kept.file)).first;
            const Result<FileOnDisk> &found = known->second;
            if (!found && found.error().code == ErrorCode::NotFound)
                report(kept, kept.name + " is missing", kept.adviceWhenMissing);
            else if (!found)
                report(kept, kept.name + ": " + found.error().why, found.error().advice);
            else if (found->bytes != kept.bytes)
                report(kept,
                       kept.name + " has " + std::to_string(found->bytes) + " bytes instead of " +
                           std::to_string(kept.bytes),
                       "put the original file back in its place");
            else if (!kept.sha256.empty())
                m_whole.push_back(&kept);
        }
        return {};
    }

    Result<void> compareHashes()
    {
        std::int64_t all = 0, done = 0;
        std::set<FileIdentity> counted;
        for (const KeptFile *kept : m_whole) {
            const FileOnDisk &file = *m_onDisk.at(kept->file);
            all += counted.insert(file.id).second ? file.bytes : 0;
        }
        std::map<FileIdentity, Result<std::string>> hashes;
        for (const KeptFile *kept : m_whole) {
            const FileOnDisk &file = *m_onDisk.at(kept->file);
            auto known = hashes.find(file.id);
            if (known == hashes.end()) {
                m_control.report(double(done) / double(std::max<std::int64_t>(all, 1)),
                                 "reading " + kept->file.filename().string());
                known = hashes.emplace(file.id, fileSha256(kept->file, m_control)).first;
                done += file.bytes;
            }
            const Result<std::string> &hash = known->second;
            if (!hash && hash.error().code == ErrorCode::Cancelled)
                return cancelled("check of the project");
            // which says nothing of the file
            if (const char *shortage = hash ? nullptr : shortageNowOfSystem())
                return fail(ErrorCode::Unavailable, "check of the project", shortage, shortageAdvice);
            if (!hash)
                report(*kept, kept->name + ": " + hash.error().why, hash.error().advice);
            else if (*hash != kept->sha256)
                report(*kept, kept->name + " was changed since it was made",
                       "put the original file back in its place");
        }
        return {};
    }

private:
    void report(const KeptFile &kept, const std::string &what, const std::string &advice)
    {
        if (m_reported.emplace(kept.file, what).second)
            m_problems.push_back({what, kept.file.string(), advice});
    }

    const JobControl &m_control;
    std::vector<ProjectProblem> &m_problems;
    std::map<std::filesystem::path, Result<FileOnDisk>> m_onDisk;
    std::vector<const KeptFile *> m_whole; ///< there, of the right size, and with a hash
    std::set<std::pair<std::filesystem::path, std::string>> m_reported;
};

} // namespace

/// Compares the files that a project refers to with what it knows of them: that they are there, their sizes
/// and, withHashes, their content. Each file is read once, however many trials and names it has (hard links
/// too), and each problem is told once. Reports the part of the bytes read. Cancelled.
Result<void> checkFiles(const std::vector<KeptFile> &files, bool withHashes, const JobControl &control,
                        std::vector<ProjectProblem> &problems)
{
    FileCheck check(control, problems);
    if (auto compared = check.compareSizes(files); !compared || !withHashes)
        return compared;
    return check.compareHashes();
}

struct ProjectConnection;

namespace {

struct TextColumn
{
    const char *table, *column;
    int most;
};
constexpr TextColumn texts[] = {{"trial", "name", maxNameLength},    {"team", "name", maxNameLength},
                                {"class", "name", maxNameLength},    {"robot", "name", maxNameLength},
                                {"camera", "name", maxNameLength},   {"layout", "name", maxNameLength},
                                {"task", "name", maxNameLength},     {"marker", "label", maxNameLength},
                                {"gate", "name", maxNameLength},     {"zone", "name", maxNameLength},
                                {"trial_tag", "tag", maxNameLength}, {"team_member", "name", maxNameLength},
                                {"trial", "notes", maxTextLength},   {"property", "value", maxNameLength}};

struct NumberColumn
{
    const char *table, *column;
    double most;
};
constexpr NumberColumn numbers[] = {{"marker", "x_m", 1000},
                                    {"marker", "y_m", 1000},
                                    {"robot", "height_m", largestRobotM},
                                    {"robot", "length_m", largestRobotM},
                                    {"robot", "width_m", largestRobotM},
                                    {"robot", "ABS(reference_forward_m)", largestRobotM},
                                    {"robot", "ABS(reference_left_m)", largestRobotM},
                                    {"recording", "frames_per_second", highestFrameRate},
                                    {"trial", "duration_s", largestNumber},
                                    {"registration", "x_m", largestNumber},
                                    {"registration", "y_m", largestNumber},
                                    {"registration", "z_m", largestNumber}};

struct ListOf
{
    const char *table, *owner;
    std::size_t most;
};
constexpr ListOf lists[] = {{"recording", "trial", mostViews},
                            {"trial_robot", "trial", mostRobots},
                            {"trial_tag", "trial", mostTags},
                            {"marker", "layout", mostMarkers}};

constexpr const char *advice = "the rest is not read; change it here, or where the file comes from";

} // namespace

/// What a file holds beyond the limits (limits.h), which is cut or left out as it is read: only another
/// program can have written it.
Result<std::vector<ProjectProblem>> beyondLimits(const ProjectConnection &connection)
{
    std::vector<ProjectProblem> problems;
    const auto count = [&](const char *sql, const char *table, const char *column, const std::string &most,
                           const auto &words) -> Result<void> {
        const auto found = connection.number(QString::fromLatin1(sql).arg(
            QLatin1String(table), QLatin1String(column), QString::fromStdString(most)));
        if (found && *found > 0)
            problems.push_back(
                {words(std::to_string(*found)), connection.file().filename().string(), advice});
        return found ? Result<void>() : tl::unexpected(found.error());
    };
    for (const TextColumn &text : texts) {
        const std::string most = std::to_string(text.most),
                          name = std::string(text.table) + "." + text.column;
        if (auto done = count("SELECT COUNT(*) FROM %1 WHERE length(%2)>%3", text.table, text.column, most,
                              [&](const std::string &found) {
                                  return name + ": texts of more than " + most + " characters: " + found;
                              });
            !done)
            return tl::unexpected(done.error());
    }
    for (const NumberColumn &number : numbers) {
        const std::string most = formatNumber(number.most, 0),
                          name = std::string(number.table) + "." + number.column;
        if (auto done = count(
                "SELECT COUNT(*) FROM %1 WHERE abs(%2)>%3", number.table, number.column, most,
                [&](const std::string &found) { return name + ": numbers beyond " + most + ": " + found; });
            !done)
            return tl::unexpected(done.error());
    }
    for (const ListOf &list : lists) {
        const std::string most = std::to_string(list.most), owner = list.owner, name = list.table;
        if (auto done = count(
                "SELECT COALESCE(MAX(n), 0) FROM (SELECT COUNT(*) AS n FROM %1 GROUP BY %2_id) WHERE n>%3",
                list.table, list.owner, most,
                [&](const std::string &found) {
                    return name + ": more than " + most + " of one " + owner + ": " + found;
                });
            !done)
            return tl::unexpected(done.error());
    }
    return problems;
}

namespace {

using Problems = std::vector<ProjectProblem>;

const std::string restoreBackup = "restore the project from a backup copy";

/// While it lives, SQLite stops what it does when the user cancels: looking through a large file is one
/// statement.
class InterruptWhenCancelled
{
public:
    InterruptWhenCancelled(const ProjectConnection &connection, const JobControl &control)
    {
        auto thread = startThread("check of the project", [this, handle = connection.handle(), &control] {
            std::unique_lock lock(m_mutex);
            while (!m_wake.wait_for(lock, std::chrono::milliseconds(100), [this] { return m_done; })) {
                if (control.isCancelled())
                    sqlite3_interrupt(handle);
            }
        });
        if (thread)
            m_thread = std::move(*thread);
    }
    ~InterruptWhenCancelled()
    {
        {
            const std::lock_guard lock(m_mutex);
            m_done = true;
        }
        m_wake.notify_one();
        if (m_thread.joinable())
            m_thread.join();
    }
    InterruptWhenCancelled(const InterruptWhenCancelled &) = delete;
    InterruptWhenCancelled &operator=(const InterruptWhenCancelled &) = delete;

private:
    std::mutex m_mutex;
    std::condition_variable m_wake;
    bool m_done = false;
    std::thread m_thread;
};

/// isThorough: indexes are compared with their tables as well.
Result<void> checkDatabase(const ProjectConnection &connection, bool isThorough, Problems &problems)
{
    const std::string where = connection.file().filename().string();
    Statement integrity(connection, isThorough ? QStringLiteral("PRAGMA integrity_check(20)")
                                               : QStringLiteral("PRAGMA quick_check(20)"));
    auto read = integrity.eachRow([&](const Statement &row) -> Result<void> {
        if (row.text(0) != "ok")
            problems.push_back({"the file is damaged: " + row.text(0), where, restoreBackup});
        return {};
    });
    if (!read)
        return read;
    Statement references(connection, QStringLiteral("PRAGMA foreign_key_check"));
    return references.eachRow([&](const Statement &row) -> Result<void> {
        problems.push_back({"row " + row.text(1) + " of '" + row.text(0) + "' refers to a row of '" +
                                row.text(2) + "' that is not there",
                            where, restoreBackup});
        return {};
    });
}

void addCalibrationFiles(Project &project, const CameraRecord &camera, std::vector<KeptFile> &files,
                         Problems &problems)
{
    const auto all = project.cameras().allIntrinsics(camera.id);
    if (!all) {
        problems.push_back(
            {all.error().what + ": " + all.error().why, "camera '" + camera.name + "'", restoreBackup});
        return;
    }
    for (const IntrinsicsRecord &record : *all) {
        for (std::size_t i = 0; i < record.files.size(); ++i) {
            const StoredPicture &picture = record.files[i];
            if (picture.path.empty())
                continue;
            files.push_back({absolutePath(project.file(), picture.path),
                             "the calibration picture '" + record.calibration.pictures[i].view.source +
                                 "' of camera '" + camera.name + "'",
                             picture.sha256, picture.bytes,
                             "put the file back in its place; the lens is kept without it"});
        }
    }
}

void addRegistrationFiles(Project &project, const CameraRecord &camera, std::vector<KeptFile> &files,
                          Problems &problems)
{
    const auto all = project.cameras().allRegistrations(camera.id);
    if (!all) {
        problems.push_back(
            {all.error().what + ": " + all.error().why, "camera '" + camera.name + "'", restoreBackup});
        return;
    }
    std::set<std::string> seen; // a registration made anew from the same markers has the same picture
    for (const RegistrationRecord &record : *all) {
        if (record.picture.path.empty() || !seen.insert(record.picture.path).second)
            continue;
        files.push_back(
            {absolutePath(project.file(), record.picture.path),
             "the picture of registration " + std::to_string(record.id) + " of camera '" + camera.name + "'",
             record.picture.sha256, record.picture.bytes,
             "put the file back in its place; the registration is kept without it"});
    }
}

/// Of trials that are complete; tells of the others.
void addRecordingFiles(Project &project, std::vector<KeptFile> &kept, Problems &problems)
{
    const auto trials = project.trials().names();
    const auto recordings = project.trials().allRecordings();
    if (!trials || !recordings) {
        const Error &error = trials ? recordings.error() : trials.error();
        problems.push_back(
            {error.what + ": " + error.why, project.file().filename().string(), restoreBackup});
        return;
    }
    std::set<RecordId> unfinished;
    for (const TrialName &trial : *trials) {
        if (!trial.unfinished)
            continue;
        unfinished.insert(trial.id);
        if (!RecordingLock::isHeld(project.mediaFolder()))
            problems.push_back(
                {"its recording was cut off; it is not complete yet", "trial '" + trial.name + "'",
                 "open the project to write, which completes it: odograph record P.odo --recover"});
    }
    for (const RecordingRecord &recording : *recordings) {
        const std::filesystem::path file = project.resolve(recording);
        if (unfinished.contains(recording.trial) && !files::exists(file))
            problems.push_back({"the recording of view '" + recording.cameraName + "' is missing",
                                file.string(), "put the file back in its place, and open the project again"});
        else if (!unfinished.contains(recording.trial))
            kept.push_back({file, "the recording of view '" + recording.cameraName + "'", recording.sha256,
                            recording.bytes,
                            "put the file back in its place, or find it by its content with odograph check "
                            "P.odo --find FOLDER or Find lost videos… in "
                            "the window; the measured track is kept without it"});
    }
}

std::vector<KeptFile> filesOf(Project &project, Problems &problems)
{
    std::vector<KeptFile> files;
    const auto cameras = project.cameras().all();
    for (const CameraRecord &camera : cameras.value_or(std::vector<CameraRecord>()))
        addCalibrationFiles(project, camera, files, problems);
    for (const CameraRecord &camera : cameras.value_or(std::vector<CameraRecord>()))
        addRegistrationFiles(project, camera, files, problems);
    addRecordingFiles(project, files, problems);
    return files;
}

/// A part of the whole progress.
JobControl partOf(const JobControl &control, double from, double to)
{
    return {control.cancel, [&control, from, to](double fraction, const std::string &text) {
                control.report(from + fraction * (to - from), text);
            }};
}

} // namespace

Result<std::vector<ProjectProblem>> checkProject(Project &project, ProjectConnection &connection,
                                                 bool withHashes, const JobControl &control)
{
    const InterruptWhenCancelled interrupt(connection, control);
    Problems problems;
    const std::string file = connection.file().filename().string();
    control.report(0, "checking the database");
    if (auto checked = checkDatabase(connection, withHashes, problems); !checked)
        problems.push_back({checked.error().why, file, restoreBackup});
    if (const auto beyond = beyondLimits(connection))
        problems.insert(problems.end(), beyond->begin(), beyond->end());
    const auto robots = project.robots().all();
    const auto tasks = checkStoredTasks(connection);
    for (const auto &[readable, error] : {std::pair{robots.has_value(), robots ? Error{} : robots.error()},
                                          std::pair{tasks.has_value(), tasks ? Error{} : tasks.error()}}) {
        if (!readable)
            problems.push_back({error.what + ": " + error.why, file, restoreBackup});
    }
    if (auto checked = checkDerivedFigures(project, connection, problems); !checked)
        problems.push_back({checked.error().what + ": " + checked.error().why, file, restoreBackup});
    const std::vector<KeptFile> files = filesOf(project, problems);
    if (auto checked = checkAnalyses(project, connection, withHashes, partOf(control, 0.1, 0.4), problems);
        !checked && !control.isCancelled())
        problems.push_back({checked.error().what + ": " + checked.error().why, file, restoreBackup});
    if (auto checked = checkFiles(files, withHashes, partOf(control, 0.4, 1), problems); !checked)
        return tl::unexpected(checked.error());
    addStrayMedia(project, problems, control);
    // What was interrupted looks like damage.
    if (control.isCancelled())
        return cancelled("check of the project");
    return problems;
}

} // namespace odo
