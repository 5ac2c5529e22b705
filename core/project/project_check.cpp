// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_check.h"

#include "core/base/file_system.h"
#include "core/project/connection.h"
#include "core/project/limit_check.h"
#include "core/project/recording_lock.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"
#include "core/project/stray_media.h"
#include "core/project/task_rows.h"

#include <set>

namespace odo {

namespace {

using Problems = std::vector<ProjectProblem>;

const std::string restoreAdvice = "restore the project from a backup copy";

Result<void> checkDatabase(const ProjectConnection &connection, Problems &problems)
{
    const std::string where = connection.file().filename().string();
    Statement integrity(connection, QStringLiteral("PRAGMA integrity_check(20)"));
    auto read = integrity.eachRow([&](const Statement &row) -> Result<void> {
        if (row.text(0) != "ok")
            problems.push_back({"the file is damaged: " + row.text(0), where, restoreAdvice});
        return {};
    });
    if (!read)
        return read;
    Statement references(connection, QStringLiteral("PRAGMA foreign_key_check"));
    return references.eachRow([&](const Statement &row) -> Result<void> {
        problems.push_back({"row " + row.text(1) + " of '" + row.text(0) + "' refers to a row of '" +
                                row.text(2) + "' that is not there",
                            where, restoreAdvice});
        return {};
    });
}

/// A file that the project refers to. name: "the recording of view 'A'".
struct KeptFile
{
    std::filesystem::path file;
    std::string name, sha256;
    std::int64_t bytes;
    std::string adviceWhenMissing;
};

void checkFile(const KeptFile &kept, bool withHash, Problems &problems)
{
    const auto report = [&](const std::string &what, const std::string &advice) {
        problems.push_back({what, kept.file.string(), advice});
    };
    std::error_code problem;
    const std::uintmax_t bytes = files::sizeOf(kept.file, problem);
    if (problem)
        return report(kept.name + " is missing", kept.adviceWhenMissing);
    if (bytes != static_cast<std::uintmax_t>(kept.bytes))
        return report(kept.name + " has " + std::to_string(bytes) + " bytes instead of " + std::to_string(kept.bytes),
                      "put the original file back in its place");
    if (!withHash || kept.sha256.empty())
        return;
    const auto hash = fileSha256(kept.file, {});
    if (!hash)
        return report(kept.name + " cannot be read", "check the disk");
    if (*hash != kept.sha256)
        report(kept.name + " was changed since it was made", "put the original file back in its place");
}

void checkCalibrations(Project &project, const CameraRecord &camera, bool withHashes, Problems &problems)
{
    const auto all = project.cameras().allIntrinsics(camera.id);
    if (!all) {
        problems.push_back({all.error().what + ": " + all.error().why, "camera '" + camera.name + "'", restoreAdvice});
        return;
    }
    for (const IntrinsicsRecord &record : *all) {
        for (std::size_t i = 0; i < record.files.size(); ++i) {
            const StoredPicture &picture = record.files[i];
            if (picture.path.empty())
                continue;
            checkFile({absolutePath(project.file(), picture.path),
                       "the calibration picture '" + record.calibration.pictures[i].view.source + "' of camera '" +
                           camera.name + "'",
                       picture.sha256, picture.bytes, "put the file back in its place; the lens is kept without it"},
                      withHashes, problems);
        }
    }
}

void checkRegistrations(Project &project, const CameraRecord &camera, bool withHashes, Problems &problems)
{
    const auto all = project.cameras().allRegistrations(camera.id);
    if (!all) {
        problems.push_back({all.error().what + ": " + all.error().why, "camera '" + camera.name + "'", restoreAdvice});
        return;
    }
    std::set<std::string> seen; // a registration made anew from the same markers has the same picture
    for (const RegistrationRecord &record : *all) {
        if (record.picture.path.empty() || !seen.insert(record.picture.path).second)
            continue;
        checkFile({absolutePath(project.file(), record.picture.path),
                   "the picture of registration " + std::to_string(record.id) + " of camera '" + camera.name + "'",
                   record.picture.sha256, record.picture.bytes,
                   "put the file back in its place; the registration is kept without it"},
                  withHashes, problems);
    }
}

void checkObservations(Project &project, const RecordingRecord &recording, const std::string &where,
                       const RobotRecord &robot, Problems &problems)
{
    const auto series = project.trials().currentObservations(recording.id, robot.id);
    if (!series) {
        problems.push_back({series.error().what + ": " + series.error().why, where, "track the trial again"});
        return;
    }
    if (!*series)
        return;
    const auto frames = static_cast<std::int64_t>(recording.frameTimes.size());
    const auto &observations = (*series)->observations;
    const bool outside =
        std::any_of(observations.begin(), observations.end(),
                    [frames](const Observation &o) { return o.frame < 0 || o.frame >= frames; });
    if (outside || static_cast<std::int64_t>(observations.size()) > frames)
        problems.push_back({"view '" + recording.cameraName + "' has " + std::to_string(frames) +
                                " frames, but the observations of '" + robot.name + "' (" +
                                std::to_string(observations.size()) + ") do not fit them",
                            where, "track the trial again"});
}

void checkTrial(Project &project, const TrialRecord &trial, const std::vector<RobotRecord> &robots,
                bool withHashes, Problems &problems)
{
    const std::string where = "trial '" + trial.name + "'";
    const auto recordings = project.trials().recordings(trial.id);
    if (!recordings) {
        problems.push_back({recordings.error().what + ": " + recordings.error().why, where, restoreAdvice});
        return;
    }
    if (trial.unfinished) {
        if (!RecordingLock::isHeld(project.mediaFolder()))
            problems.push_back({"its recording was cut off; it is not complete yet", where,
                                "open the project to write, which completes it: odograph record P.odo --recover"});
        return;
    }
    for (const RecordingRecord &recording : *recordings) {
        checkFile({project.resolve(recording), "the recording of view '" + recording.cameraName + "'", recording.sha256,
                   recording.bytes,
                   "put the file back in its place, or find it by its content with odograph check P.odo --find FOLDER or Find lost videos… in "
                   "the window; the measured track is kept without it"},
                  withHashes, problems);
        for (const RobotRecord &robot : robots)
            checkObservations(project, recording, where, robot, problems);
    }
    for (const RobotRecord &robot : robots) {
        if (const auto track = project.trials().currentImportedTrack(trial.id, robot.id); !track)
            problems.push_back({track.error().what + ": " + track.error().why, where, restoreAdvice});
    }
    if (const auto analyses = project.analyses().current(trial.id); !analyses)
        problems.push_back(
            {analyses.error().what + ": " + analyses.error().why, where, "track the trial again"});
}

} // namespace

Result<std::vector<ProjectProblem>> checkProject(Project &project, ProjectConnection &connection,
                                                 bool withHashes)
{
    Problems problems;
    if (auto checked = checkDatabase(connection, problems); !checked)
        problems.push_back({checked.error().why, connection.file().filename().string(), restoreAdvice});
    if (const auto beyond = beyondLimits(connection))
        problems.insert(problems.end(), beyond->begin(), beyond->end());
    const auto robots = project.robots().all();
    const auto tasks = checkStoredTasks(connection);
    const auto trials = project.trials().all();
    for (const auto &[readable, error] : {std::pair{robots.has_value(), robots ? Error{} : robots.error()},
                                          std::pair{tasks.has_value(), tasks ? Error{} : tasks.error()},
                                          std::pair{trials.has_value(), trials ? Error{} : trials.error()}}) {
        if (!readable)
            problems.push_back(
                {error.what + ": " + error.why, connection.file().filename().string(), restoreAdvice});
    }
    if (!robots || !trials)
        return problems;
    if (const auto cameras = project.cameras().all()) {
        for (const CameraRecord &camera : *cameras)
            checkCalibrations(project, camera, withHashes, problems);
        for (const CameraRecord &camera : *cameras)
            checkRegistrations(project, camera, withHashes, problems);
    }
    for (const TrialRecord &trial : *trials)
        checkTrial(project, trial, *robots, withHashes, problems);
    addStrayMedia(project, problems);
    return problems;
}

} // namespace odo
