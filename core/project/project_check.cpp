// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_check.h"

#include "core/base/file_system.h"
#include "core/base/shortage.h"
#include "core/project/analysis_check.h"
#include "core/project/checked_files.h"
#include "core/project/connection.h"
#include "core/project/derived_figures_check.h"
#include "core/project/limit_check.h"
#include "core/project/recording_lock.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"
#include "core/project/stray_media.h"
#include "core/project/task_rows.h"

#include <condition_variable>
#include <mutex>
#include <set>
#include <sqlite3.h>

namespace odo {

namespace {

using Problems = std::vector<ProjectProblem>;

const std::string restoreBackup = "restore the project from a backup copy";

/// While it lives, SQLite stops what it does when the user cancels: looking through a large file is one statement.
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
    Statement integrity(connection, isThorough ? QStringLiteral("PRAGMA integrity_check(20)") : QStringLiteral("PRAGMA quick_check(20)"));
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

void addCalibrationFiles(Project &project, const CameraRecord &camera, std::vector<KeptFile> &files, Problems &problems)
{
    const auto all = project.cameras().allIntrinsics(camera.id);
    if (!all) {
        problems.push_back({all.error().what + ": " + all.error().why, "camera '" + camera.name + "'", restoreBackup});
        return;
    }
    for (const IntrinsicsRecord &record : *all) {
        for (std::size_t i = 0; i < record.files.size(); ++i) {
            const StoredPicture &picture = record.files[i];
            if (picture.path.empty())
                continue;
            files.push_back({absolutePath(project.file(), picture.path),
                             "the calibration picture '" + record.calibration.pictures[i].view.source + "' of camera '" +
                                 camera.name + "'",
                             picture.sha256, picture.bytes, "put the file back in its place; the lens is kept without it"});
        }
    }
}

void addRegistrationFiles(Project &project, const CameraRecord &camera, std::vector<KeptFile> &files, Problems &problems)
{
    const auto all = project.cameras().allRegistrations(camera.id);
    if (!all) {
        problems.push_back({all.error().what + ": " + all.error().why, "camera '" + camera.name + "'", restoreBackup});
        return;
    }
    std::set<std::string> seen; // a registration made anew from the same markers has the same picture
    for (const RegistrationRecord &record : *all) {
        if (record.picture.path.empty() || !seen.insert(record.picture.path).second)
            continue;
        files.push_back({absolutePath(project.file(), record.picture.path),
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
        problems.push_back({error.what + ": " + error.why, project.file().filename().string(), restoreBackup});
        return;
    }
    std::set<RecordId> unfinished;
    for (const TrialName &trial : *trials) {
        if (!trial.unfinished)
            continue;
        unfinished.insert(trial.id);
        if (!RecordingLock::isHeld(project.mediaFolder()))
            problems.push_back({"its recording was cut off; it is not complete yet", "trial '" + trial.name + "'",
                                "open the project to write, which completes it: odograph record P.odo --recover"});
    }
    for (const RecordingRecord &recording : *recordings) {
        const std::filesystem::path file = project.resolve(recording);
        if (unfinished.contains(recording.trial) && !files::exists(file))
            problems.push_back({"the recording of view '" + recording.cameraName + "' is missing", file.string(),
                                "put the file back in its place, and open the project again"});
        else if (!unfinished.contains(recording.trial))
            kept.push_back({file, "the recording of view '" + recording.cameraName + "'", recording.sha256, recording.bytes,
                             "put the file back in its place, or find it by its content with odograph check P.odo --find FOLDER or Find lost videos… in "
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

Result<std::vector<ProjectProblem>> checkProject(Project &project, ProjectConnection &connection, bool withHashes, const JobControl &control)
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
    if (auto checked = checkAnalyses(project, connection, withHashes, partOf(control, 0.1, 0.4), problems); !checked && !control.isCancelled())
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
