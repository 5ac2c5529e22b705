// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/project_check.h"

#include "core/base/error.h"
#include "core/base/file_system.h"
#include "core/base/job_control.h"
#include "core/base/shortage.h"
#include "core/base/units.h"
#include "core/files/file_words.h"
#include "core/files/protected_files.h"
#include "core/project/internal/analysis_check.h"
#include "core/project/internal/connection.h"
#include "core/project/internal/task_repository.h"
#include "core/project/internal/words.h"
#include "core/project/names.h"
#include "core/project/project.h"
#include "core/project/project_locks.h"
#include "core/project/project_media.h"
#include "core/project/project_words.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"

#include <algorithm>
#include <condition_variable>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <sqlite3.h>
#include <string>
#include <utility>
#include <vector>

namespace odo {

/// A file that the project refers to. name: "the recording of view 'A'".
struct KeptFile
{
    std::filesystem::path file; ///< absolute
    Message name;
    std::string sha256; ///< empty: it has not been made yet
    std::int64_t bytes = 0;
    Message adviceWhenMissing;
};

namespace {

Message restoreOriginal()
{
    return ODO_TEXT("project.put_original_back", "move the original file back to its folder");
}

/// NotFound where there is nothing, Io where the system does not say, InvalidInput where something else is in
/// its place.
Result<FileStatus> onDisk(const std::filesystem::path &file)
{
    const Message what = quotedFileSubject(file);
    const auto status = statusOf(file);
    if (!status) {
        const bool isMissing = status.error() == std::errc::no_such_file_or_directory ||
                               status.error() == std::errc::not_a_directory;
        return fail(isMissing ? ErrorCode::NotFound : ErrorCode::Io, what,
                    cannotBeRead(status.error().message()), checkFileIsThere());
    }
    if (status->kind != files::Kind::File)
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("project.no_file_but_other", "it is a folder or a device, not a file"),
                    restoreOriginal());
    return *status;
}

class FileCheck
{
public:
    FileCheck(const JobControl &control, std::vector<ProjectProblem> &problems)
        : m_control(control), m_problems(problems)
    {
    }

    /// Checks that the files exist, and remembers those whose content is to be checked.
    Result<void> compareSizes(const std::vector<KeptFile> &files)
    {
        for (const KeptFile &kept : files) {
            if (m_control.isCancelled())
                return cancelled(projectCheck());
            auto known = m_onDisk.find(kept.file);
            if (known == m_onDisk.end())
                known = m_onDisk.emplace(kept.file, onDisk(kept.file)).first;
            const Result<FileStatus> &found = known->second;
            if (!found && found.error().code == ErrorCode::NotFound)
                report(kept, isMissing(kept.name), kept.adviceWhenMissing);
            else if (!found)
                report(kept, joined({kept.name, found.error().why}, Join::Colon), found.error().advice);
            else if (found->bytes != kept.bytes)
                report(kept,
                       ODO_TEXT("project.has_other_size",
                                "%1 has %2 bytes instead of %3")(kept.name, found->bytes, kept.bytes),
                       restoreOriginal());
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
            const FileStatus &file = *m_onDisk.at(kept->file);
            all += counted.insert(file.identity).second ? file.bytes : 0;
        }
        std::map<FileIdentity, Result<std::string>> hashes;
        for (const KeptFile *kept : m_whole) {
            const FileStatus &file = *m_onDisk.at(kept->file);
            auto known = hashes.find(file.identity);
            if (known == hashes.end()) {
                m_control.report(double(done) / double(std::max<std::int64_t>(all, 1)),
                                 readingFile(kept->file));
                known = hashes.emplace(file.identity, fileSha256(kept->file, m_control)).first;
                done += file.bytes;
            }
            const Result<std::string> &hash = known->second;
            if (!hash && hash.error().code == ErrorCode::Cancelled)
                return cancelled(projectCheck());
            // which says nothing of the file
            if (const MessageText *shortage = hash ? nullptr : shortageNowOfSystem())
                return fail(ErrorCode::Unavailable, projectCheck(), *shortage, shortageAdvice());
            if (!hash)
                report(*kept, joined({kept->name, hash.error().why}, Join::Colon), hash.error().advice);
            else if (*hash != kept->sha256)
                report(*kept,
                       ODO_TEXT("project.file_changed", "%1 has changed since it was created")(kept->name),
                       restoreOriginal());
        }
        return {};
    }

private:
    void report(const KeptFile &kept, const Message &what, const Message &advice)
    {
        std::vector<Message> &reported = m_reported[kept.file];
        if (std::ranges::find(reported, what) != reported.end())
            return;
        reported.push_back(what);
        m_problems.push_back({what, fileSubject(kept.file), advice});
    }

    const JobControl &m_control;
    std::vector<ProjectProblem> &m_problems;
    std::map<std::filesystem::path, Result<FileStatus>> m_onDisk;
    std::vector<const KeptFile *> m_whole; ///< there, of the right size, and with a hash
    std::map<std::filesystem::path, std::vector<Message>> m_reported;
};

} // namespace

/// Compares the files that a project refers to with what it knows of them: that they are there, their sizes
/// and, withHashes, their content. Each file is read once, however many trials and names it has (hard links
/// too), and each problem is reported once. Reports the part of the bytes read. Cancelled.
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
constexpr TextColumn texts[] = {{"trial", "name", maxNameLength},
                                {"team", "name", maxNameLength},
                                {"class", "name", maxNameLength},
                                {"robot", "name", maxNameLength},
                                {"camera", "name", maxNameLength},
                                {"layout", "name", maxNameLength},
                                {"task", "name", maxNameLength},
                                {"marker", "label", maxNameLength},
                                {"gate", "name", maxNameLength},
                                {"zone", "name", maxNameLength},
                                {"trial_tag", "tag", maxNameLength},
                                {"trial_variable", "name", maxNameLength},
                                {"trial_variable", "value", maxNameLength},
                                {"team_member", "name", maxNameLength},
                                {"trial", "notes", maxTextLength},
                                {"property", "value", maxNameLength}};

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
                            {"trial_variable", "trial", mostVariables},
                            {"marker", "layout", mostMarkers}};

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
                {words(*found), fileSubject(connection.file().filename()),
                 ODO_TEXT("project.rest_not_read", "Odograph does not read the rest; shorten it here, or in "
                                                   "the program that wrote the file")});
        return found ? Result<void>() : tl::unexpected(found.error());
    };
    for (const TextColumn &text : texts) {
        const auto words = [&](std::int64_t found) {
            return ODO_TEXT("project.texts_too_long", "%1: texts of more than %2 characters: %3")(
                std::string(text.table) + "." + text.column, text.most, found);
        };
        ODO_TRY(count("SELECT COUNT(*) FROM %1 WHERE length(%2)>%3", text.table, text.column,
                      std::to_string(text.most), words));
    }
    for (const NumberColumn &number : numbers) {
        const auto words = [&](std::int64_t found) {
            return ODO_TEXT("project.numbers_too_large", "%1: numbers beyond %2: %3")(
                std::string(number.table) + "." + number.column, quantity(number.most, 0), found);
        };
        ODO_TRY(count("SELECT COUNT(*) FROM %1 WHERE abs(%2)>%3", number.table, number.column,
                      formatNumber(number.most, 0), words));
    }
    for (const ListOf &list : lists) {
        const auto words = [&](std::int64_t found) {
            return ODO_TEXT("project.lists_too_long", "%1: more than %2 of one %3: %4")(
                std::string(list.table), list.most, std::string(list.owner), found);
        };
        ODO_TRY(
            count("SELECT COALESCE(MAX(n), 0) FROM (SELECT COUNT(*) AS n FROM %1 GROUP BY %2_id) WHERE n>%3",
                  list.table, list.owner, std::to_string(list.most), words));
    }
    return problems;
}

namespace {

using Problems = std::vector<ProjectProblem>;

/// While it lives, SQLite stops what it does when the user cancels: checking a large file is one
/// statement.
class InterruptWhenCancelled
{
public:
    InterruptWhenCancelled(const ProjectConnection &connection, const JobControl &control)
    {
        auto thread = startThread(projectCheck(), [this, handle = connection.handle(), &control] {
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
    const Message where = fileSubject(connection.file().filename());
    Statement integrity(connection, isThorough ? QStringLiteral("PRAGMA integrity_check(20)")
                                               : QStringLiteral("PRAGMA quick_check(20)"));
    auto read = integrity.eachRow([&](const Statement &row) -> Result<void> {
        if (row.text(0) != "ok")
            problems.push_back(
                {joined({fileIsDamaged(), foreignWords(row.text(0))}, Join::Colon), where, restoreProject()});
        return {};
    });
    if (!read)
        return read;
    Statement references(connection, QStringLiteral("PRAGMA foreign_key_check"));
    return references.eachRow([&](const Statement &row) -> Result<void> {
        problems.push_back(
            {ODO_TEXT("project.row_refers_to_nothing", "row %1 of '%2' refers to a missing row of '%3'")(
                 row.text(1), row.text(0), row.text(2)),
             where, restoreProject()});
        return {};
    });
}

void addCalibrationFiles(Project &project, const CameraRecord &camera, std::vector<KeptFile> &files,
                         Problems &problems)
{
    const auto all = project.cameras().allIntrinsics(camera.id);
    if (!all) {
        problems.push_back(
            {wholeMessage(all.error().what, all.error().why), cameraSubject(camera.name), restoreProject()});
        return;
    }
    for (const IntrinsicsRecord &record : *all) {
        for (std::size_t i = 0; i < record.files.size(); ++i) {
            const StoredImage &image = record.files[i];
            if (image.path.empty())
                continue;
            files.push_back(
                {absolutePath(project.file(), image.path),
                 ODO_TEXT("project.calibration_picture_of", "the calibration image '%1' of camera '%2'")(
                     Named::file(record.calibration.images[i].view.source), Named::camera(camera.name)),
                 image.sha256, image.bytes,
                 joined({returnFile(),
                         ODO_TEXT("project.lens_kept", "the lens calibration remains valid without it")},
                        Join::Semicolon)});
        }
    }
}

void addRegistrationFiles(Project &project, const CameraRecord &camera, std::vector<KeptFile> &files,
                          Problems &problems)
{
    const auto all = project.cameras().allRegistrations(camera.id);
    if (!all) {
        problems.push_back(
            {wholeMessage(all.error().what, all.error().why), cameraSubject(camera.name), restoreProject()});
        return;
    }
    std::set<std::string> seen; // a registration recomputed from the same markers has the same image
    for (const RegistrationRecord &record : *all) {
        if (record.image.path.empty() || !seen.insert(record.image.path).second)
            continue;
        files.push_back(
            {absolutePath(project.file(), record.image.path),
             ODO_TEXT("project.registration_picture_of",
                      "the image of registration %1 of camera '%2'")(record.id, Named::camera(camera.name)),
             record.image.sha256, record.image.bytes,
             joined({returnFile(),
                     ODO_TEXT("project.registration_kept", "the registration remains valid without it")},
                    Join::Semicolon)});
    }
}

/// Of trials that are complete; reports the others.
void addRecordingFiles(Project &project, std::vector<KeptFile> &kept, Problems &problems)
{
    const auto trials = project.trials().names();
    const auto recordings = project.trials().allRecordings();
    if (!trials || !recordings) {
        const Error &error = trials ? recordings.error() : trials.error();
        problems.push_back(
            {wholeMessage(error.what, error.why), fileSubject(project.file().filename()), restoreProject()});
        return;
    }
    std::set<RecordId> unfinished;
    for (const TrialName &trial : *trials) {
        if (!trial.unfinished)
            continue;
        unfinished.insert(trial.id);
        if (!RecordingLock::isHeld(project.mediaFolder()))
            problems.push_back(
                {joined(
                     {recordingWasCutOff(), ODO_TEXT("project.not_complete_yet", "it is not complete yet")},
                     Join::Semicolon),
                 trialSubject(trial.name),
                 ODO_TEXT("project.complete_recording",
                          "to complete it, open the project for writing: odograph record P.odo --recover")});
    }
    for (const RecordingRecord &recording : *recordings) {
        const std::filesystem::path file = project.resolve(recording);
        const Message name = ODO_TEXT("project.recording_of_view",
                                      "the recording of view '%1'")(Named::camera(recording.cameraName));
        if (unfinished.contains(recording.trial) && !files::exists(file))
            problems.push_back({isMissing(name), fileSubject(file), restoreAndReopen()});
        else if (!unfinished.contains(recording.trial))
            kept.push_back(
                {file, name, recording.sha256, recording.bytes,
                 joined({ODO_TEXT("project.put_back_or_find",
                                  "move the file back to its folder, or find it by its content with odograph "
                                  "check P.odo --find FOLDER or Find lost videos… in the window"),
                         ODO_TEXT("project.track_kept", "the measured track remains valid without it")},
                        Join::Semicolon)});
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

} // namespace

Result<std::vector<ProjectProblem>> checkProject(Project &project, ProjectConnection &connection,
                                                 bool withHashes, const JobControl &control)
{
    const InterruptWhenCancelled interrupt(connection, control);
    Problems problems;
    const Message file = fileSubject(connection.file().filename());
    control.report(0, ODO_TEXT("project.checking_database", "checking the database"));
    if (auto checked = checkDatabase(connection, withHashes, problems); !checked)
        problems.push_back({checked.error().why, file, restoreProject()});
    if (const auto beyond = beyondLimits(connection))
        problems.insert(problems.end(), beyond->begin(), beyond->end());
    const auto robots = project.robots().all();
    const auto tasks = checkStoredTasks(connection);
    for (const auto &[readable, error] : {std::pair{robots.has_value(), robots ? Error{} : robots.error()},
                                          std::pair{tasks.has_value(), tasks ? Error{} : tasks.error()}}) {
        if (!readable)
            problems.push_back({wholeMessage(error.what, error.why), file, restoreProject()});
    }
    if (auto checked = checkDerivedMetrics(project, connection, problems); !checked)
        problems.push_back({wholeMessage(checked.error().what, checked.error().why), file, restoreProject()});
    const std::vector<KeptFile> files = filesOf(project, problems);
    if (auto checked = checkAnalyses(project, connection, withHashes, partOf(control, 0.1, 0.4), problems);
        !checked && !control.isCancelled())
        problems.push_back({wholeMessage(checked.error().what, checked.error().why), file, restoreProject()});
    ODO_TRY(checkFiles(files, withHashes, partOf(control, 0.4, 1), problems));
    addStrayMedia(project, problems, control);
    // What was interrupted looks like damage.
    if (control.isCancelled())
        return cancelled(projectCheck());
    return problems;
}

} // namespace odo
