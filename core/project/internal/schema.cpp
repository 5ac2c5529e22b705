// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/schema.h"

#include "core/project/internal/message_migration.h"

namespace odo {

namespace {

// Units and meanings are those of core/project/records.h; docs/project_file.md describes tables and blobs.
std::vector<std::string> firstSchema()
{
    return {
        "CREATE TABLE property (name TEXT PRIMARY KEY, value TEXT NOT NULL)",

        "CREATE TABLE camera (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, device_uri TEXT NOT NULL)",
        "CREATE TABLE lens (id INTEGER PRIMARY KEY, width_px INTEGER NOT NULL, height_px INTEGER NOT NULL, "
        "fx_px REAL NOT NULL, fy_px REAL NOT NULL, cx_px REAL NOT NULL, cy_px REAL NOT NULL, model TEXT NOT "
        "NULL, "
        "distortion BLOB NOT NULL, covariance BLOB NOT NULL)",
        "CREATE TABLE intrinsics (id INTEGER PRIMARY KEY, camera_id INTEGER NOT NULL REFERENCES camera(id), "
        "lens_id INTEGER NOT NULL REFERENCES lens(id), made_ms INTEGER NOT NULL, origin TEXT NOT NULL, "
        "rms_px REAL NOT NULL, cross_validation_px REAL NOT NULL, verdict TEXT NOT NULL)",
        "CREATE INDEX intrinsics_by_camera ON intrinsics(camera_id)",
        "CREATE TABLE calibration_picture (intrinsics_id INTEGER NOT NULL REFERENCES intrinsics(id), "
        "position INTEGER NOT NULL, file TEXT NOT NULL, rms_px REAL NOT NULL, "
        "PRIMARY KEY (intrinsics_id, position))",
        "CREATE TABLE rejected_picture (intrinsics_id INTEGER NOT NULL REFERENCES intrinsics(id), "
        "position INTEGER NOT NULL, file TEXT NOT NULL, reason TEXT NOT NULL, "
        "PRIMARY KEY (intrinsics_id, position))",

        "CREATE TABLE layout (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE)",
        "CREATE TABLE marker (layout_id INTEGER NOT NULL REFERENCES layout(id), position INTEGER NOT NULL, "
        "label TEXT NOT NULL, x_m REAL NOT NULL, y_m REAL NOT NULL, PRIMARY KEY (layout_id, position), "
        "UNIQUE (layout_id, label))",
        "CREATE TABLE registration (id INTEGER PRIMARY KEY, camera_id INTEGER NOT NULL REFERENCES "
        "camera(id), "
        "layout_id INTEGER NOT NULL REFERENCES layout(id), intrinsics_id INTEGER REFERENCES intrinsics(id), "
        "assumed_lens_id INTEGER NOT NULL REFERENCES lens(id), made_ms INTEGER NOT NULL, "
        "qw REAL NOT NULL, qx REAL NOT NULL, qy REAL NOT NULL, qz REAL NOT NULL, "
        "x_m REAL NOT NULL, y_m REAL NOT NULL, z_m REAL NOT NULL, pose_covariance BLOB NOT NULL, "
        "rms_px REAL NOT NULL, rms_m REAL NOT NULL, verdict TEXT NOT NULL)",
        "CREATE INDEX registration_by_camera ON registration(camera_id)",
        "CREATE TABLE registration_pixel (registration_id INTEGER NOT NULL REFERENCES registration(id), "
        "position INTEGER NOT NULL, label TEXT NOT NULL, u_px REAL NOT NULL, v_px REAL NOT NULL, "
        "PRIMARY KEY (registration_id, position))",
        "CREATE TABLE registration_error (registration_id INTEGER NOT NULL REFERENCES registration(id), "
        "position INTEGER NOT NULL, label TEXT NOT NULL, error_m REAL NOT NULL, error_px REAL NOT NULL, "
        "PRIMARY KEY (registration_id, position))",

        "CREATE TABLE robot (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, colour TEXT NOT NULL, "
        "height_mode TEXT NOT NULL, height_m REAL, length_m REAL, width_m REAL)",
        "CREATE TABLE class (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE)",
        "CREATE TABLE team (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, class_id INTEGER REFERENCES "
        "class(id))",
        "CREATE TABLE task (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE)",

        "CREATE TABLE trial (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, team_id INTEGER REFERENCES "
        "team(id), "
        "task_id INTEGER REFERENCES task(id), date_ms INTEGER NOT NULL, notes TEXT NOT NULL, "
        "sync_method TEXT NOT NULL, sync_offset_s REAL NOT NULL, sync_offset_sigma_s REAL NOT NULL, "
        "sync_score REAL NOT NULL, duration_s REAL NOT NULL)",
        "CREATE INDEX trial_by_date ON trial(date_ms)",
        "CREATE TABLE trial_robot (trial_id INTEGER NOT NULL REFERENCES trial(id), position INTEGER NOT "
        "NULL, "
        "robot_id INTEGER NOT NULL REFERENCES robot(id), PRIMARY KEY (trial_id, position), "
        "UNIQUE (trial_id, robot_id))",
        "CREATE TABLE recording (id INTEGER PRIMARY KEY, trial_id INTEGER NOT NULL REFERENCES trial(id), "
        "camera_id INTEGER NOT NULL REFERENCES camera(id), position INTEGER NOT NULL, path TEXT NOT NULL, "
        "sha256 TEXT NOT NULL, bytes INTEGER NOT NULL, width_px INTEGER NOT NULL, height_px INTEGER NOT "
        "NULL, "
        "frames_per_second REAL NOT NULL, start_offset_s REAL NOT NULL, UNIQUE (trial_id, position))",
        "CREATE TABLE frame_time_chunk (recording_id INTEGER NOT NULL REFERENCES recording(id), "
        "position INTEGER NOT NULL, times BLOB NOT NULL, PRIMARY KEY (recording_id, position))",

        "CREATE TABLE observation_series (id INTEGER PRIMARY KEY, "
        "recording_id INTEGER NOT NULL REFERENCES recording(id), robot_id INTEGER NOT NULL REFERENCES "
        "robot(id), "
        "algorithm TEXT NOT NULL)",
        "CREATE INDEX observation_series_by_recording ON observation_series(recording_id, robot_id)",
        "CREATE TABLE observation_chunk (series_id INTEGER NOT NULL REFERENCES observation_series(id), "
        "position INTEGER NOT NULL, observations BLOB NOT NULL, PRIMARY KEY (series_id, position))",
        "CREATE TRIGGER observation_series_kept_on_update BEFORE UPDATE ON observation_series "
        "BEGIN SELECT RAISE(ABORT, 'observations are never changed'); END",
        "CREATE TRIGGER observation_series_kept_on_delete BEFORE DELETE ON observation_series "
        "BEGIN SELECT RAISE(ABORT, 'observations are never deleted'); END",
        "CREATE TRIGGER observation_chunk_kept_on_update BEFORE UPDATE ON observation_chunk "
        "BEGIN SELECT RAISE(ABORT, 'observations are never changed'); END",
        "CREATE TRIGGER observation_chunk_kept_on_delete BEFORE DELETE ON observation_chunk "
        "BEGIN SELECT RAISE(ABORT, 'observations are never deleted'); END",

        "CREATE TABLE analysis (id INTEGER PRIMARY KEY, trial_id INTEGER NOT NULL REFERENCES trial(id), "
        "robot_id INTEGER NOT NULL REFERENCES robot(id), made_ms INTEGER NOT NULL, software_version TEXT NOT "
        "NULL, "
        "smoother TEXT NOT NULL, max_speed_m_s REAL NOT NULL, max_accel_m_s2 REAL NOT NULL, "
        "longest_bridged_gap_ns INTEGER NOT NULL, height_m REAL NOT NULL, height_estimated INTEGER NOT NULL, "
        "mean_view_disagreement_m REAL NOT NULL)",
        "CREATE INDEX analysis_by_trial ON analysis(trial_id, robot_id)",
        "CREATE TABLE analysis_series (analysis_id INTEGER PRIMARY KEY REFERENCES analysis(id), "
        "samples BLOB NOT NULL, points BLOB NOT NULL)",
        "CREATE TABLE analysis_view (analysis_id INTEGER NOT NULL REFERENCES analysis(id), "
        "position INTEGER NOT NULL, name TEXT NOT NULL, registration_id INTEGER REFERENCES registration(id), "
        "PRIMARY KEY (analysis_id, position))",
        "CREATE TABLE metric (analysis_id INTEGER NOT NULL REFERENCES analysis(id), position INTEGER NOT "
        "NULL, "
        "name TEXT NOT NULL, unit TEXT NOT NULL, value REAL NOT NULL, sigma REAL, "
        "PRIMARY KEY (analysis_id, position))",
        "CREATE TABLE spike (analysis_id INTEGER NOT NULL REFERENCES analysis(id), position INTEGER NOT "
        "NULL, "
        "sample_index INTEGER NOT NULL, time_ns INTEGER NOT NULL, flags INTEGER NOT NULL, reason TEXT NOT "
        "NULL, "
        "PRIMARY KEY (analysis_id, position))",

        "CREATE TABLE truth (trial_id INTEGER NOT NULL REFERENCES trial(id), "
        "robot_id INTEGER NOT NULL REFERENCES robot(id), series BLOB NOT NULL, PRIMARY KEY (trial_id, "
        "robot_id))",
    };
}

/// A person's word on single samples: the one in force of each trial and robot, and the one each analysis was
/// made with.
std::vector<std::string> overrules()
{
    return {
        "CREATE TABLE overrule (trial_id INTEGER NOT NULL REFERENCES trial(id), "
        "robot_id INTEGER NOT NULL REFERENCES robot(id), frame INTEGER NOT NULL, is_spike INTEGER NOT NULL, "
        "PRIMARY KEY (trial_id, robot_id, frame))",
        "CREATE TABLE analysis_overrule (analysis_id INTEGER NOT NULL REFERENCES analysis(id), "
        "frame INTEGER NOT NULL, is_spike INTEGER NOT NULL, PRIMARY KEY (analysis_id, frame))",
    };
}

/// Cameras' clocks do not only start apart, they drift apart as well.
std::vector<std::string> clockRates()
{
    return {
        "ALTER TABLE recording ADD COLUMN clock_rate REAL NOT NULL DEFAULT 0",
        "ALTER TABLE trial ADD COLUMN sync_rate REAL NOT NULL DEFAULT 0",
        "ALTER TABLE trial ADD COLUMN sync_rate_sigma REAL NOT NULL DEFAULT 0",
    };
}

/// A task was a name alone; now it says what is to be driven, and an analysis which task it was measured by.
std::vector<std::string> tasks()
{
    return {
        "ALTER TABLE task ADD COLUMN template TEXT NOT NULL DEFAULT 'free'",
        "ALTER TABLE task ADD COLUMN path_points BLOB",
        "ALTER TABLE task ADD COLUMN path_closed INTEGER NOT NULL DEFAULT 0",
        "ALTER TABLE task ADD COLUMN max_speed_m_s REAL",
        "ALTER TABLE task ADD COLUMN max_accel_m_s2 REAL",
        "CREATE TABLE gate (task_id INTEGER NOT NULL REFERENCES task(id), position INTEGER NOT NULL, "
        "name TEXT NOT NULL, role TEXT NOT NULL, from_x_m REAL NOT NULL, from_y_m REAL NOT NULL, "
        "to_x_m REAL NOT NULL, to_y_m REAL NOT NULL, PRIMARY KEY (task_id, position), UNIQUE (task_id, "
        "name))",
        "ALTER TABLE analysis ADD COLUMN task_id INTEGER REFERENCES task(id)",
        "CREATE TABLE gate_passage (analysis_id INTEGER NOT NULL REFERENCES analysis(id), "
        "position INTEGER NOT NULL, gate TEXT NOT NULL, role TEXT NOT NULL, time_ns INTEGER NOT NULL, "
        "sigma_s REAL NOT NULL, common_sigma_s REAL NOT NULL, PRIMARY KEY (analysis_id, position))",
    };
}

/// Each view can be put in step with the first one in its own way.
std::vector<std::string> viewsInStep()
{
    return {
        "ALTER TABLE recording ADD COLUMN sync_method TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE recording ADD COLUMN start_offset_sigma_s REAL NOT NULL DEFAULT 0",
        "UPDATE recording SET sync_method=(SELECT sync_method FROM trial WHERE trial.id=trial_id) "
        "WHERE position>0",
        "UPDATE recording SET start_offset_sigma_s=(SELECT sync_offset_sigma_s FROM trial WHERE "
        "trial.id=trial_id) WHERE position=1",
    };
}

/// Calibrations with what they were made from: the board, the corners found, and the pictures.
std::vector<std::string> calibrationPictures()
{
    return {
        "ALTER TABLE intrinsics ADD COLUMN software_version TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE intrinsics ADD COLUMN board_pattern TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE intrinsics ADD COLUMN board_columns INTEGER NOT NULL DEFAULT 0",
        "ALTER TABLE intrinsics ADD COLUMN board_rows INTEGER NOT NULL DEFAULT 0",
        "ALTER TABLE intrinsics ADD COLUMN square_m REAL NOT NULL DEFAULT 0",
        "ALTER TABLE intrinsics ADD COLUMN marker_ratio REAL NOT NULL DEFAULT 0",
        "ALTER TABLE intrinsics ADD COLUMN dictionary TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE intrinsics ADD COLUMN lens_reason TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE intrinsics ADD COLUMN disagreeing_part REAL NOT NULL DEFAULT 0",
        "ALTER TABLE calibration_picture ADD COLUMN used INTEGER NOT NULL DEFAULT 1",
        "ALTER TABLE calibration_picture ADD COLUMN corners BLOB",
        "ALTER TABLE calibration_picture ADD COLUMN path TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE calibration_picture ADD COLUMN sha256 TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE calibration_picture ADD COLUMN bytes INTEGER NOT NULL DEFAULT 0",
    };
}

/// Which revision is in force can be chosen, and whether a camera still stands where it was registered is
/// kept.
std::vector<std::string> chosenRevisions()
{
    return {
        "ALTER TABLE camera ADD COLUMN intrinsics_id INTEGER REFERENCES intrinsics(id)",
        "ALTER TABLE camera ADD COLUMN registration_id INTEGER REFERENCES registration(id)",
        "ALTER TABLE registration ADD COLUMN software_version TEXT NOT NULL DEFAULT ''",
        "CREATE TABLE registration_check (id INTEGER PRIMARY KEY, "
        "registration_id INTEGER NOT NULL REFERENCES registration(id), made_ms INTEGER NOT NULL, "
        "outcome TEXT NOT NULL, shift_px REAL NOT NULL, shift_m REAL NOT NULL, words TEXT NOT NULL)",
        "CREATE INDEX registration_check_by_registration ON registration_check(registration_id)",
    };
}

/// A trial stands in the project while it is being recorded, with the raw times of its pictures, which are
/// kept.
std::vector<std::string> recordingsAsTheyAreMade()
{
    return {
        "ALTER TABLE trial ADD COLUMN state TEXT NOT NULL DEFAULT 'complete'",
        "CREATE TABLE raw_time_chunk (recording_id INTEGER NOT NULL REFERENCES recording(id), position "
        "INTEGER NOT NULL, "
        "pictures BLOB NOT NULL, readings BLOB NOT NULL, PRIMARY KEY (recording_id, position))",
        "CREATE TRIGGER raw_time_chunk_kept_on_update BEFORE UPDATE ON raw_time_chunk "
        "BEGIN SELECT RAISE(ABORT, 'raw times are never changed'); END",
        "CREATE TRIGGER raw_time_chunk_kept_on_delete BEFORE DELETE ON raw_time_chunk "
        "WHEN (SELECT trial.state FROM recording JOIN trial ON trial.id=recording.trial_id "
        "WHERE recording.id=OLD.recording_id)<>'recording' "
        "BEGIN SELECT RAISE(ABORT, 'raw times are never deleted'); END",
    };
}

/// Registrations with the picture in which their markers were seen.
std::vector<std::string> registrationPictures()
{
    return {
        "ALTER TABLE registration ADD COLUMN picture_path TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE registration ADD COLUMN picture_sha256 TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE registration ADD COLUMN picture_bytes INTEGER NOT NULL DEFAULT 0",
    };
}

/// What a class needs through the year: trials are starred, tagged, archived and binned, teams have
/// pseudonyms, tasks are scored, and every change is told. What lies in the bin may be removed for good, raw
/// measurements with it: a pupil's data are the pupil's.
std::vector<std::string> schoolYear()
{
    return {
        "ALTER TABLE trial ADD COLUMN starred INTEGER NOT NULL DEFAULT 0",
        "ALTER TABLE trial ADD COLUMN archived_ms INTEGER",
        "ALTER TABLE trial ADD COLUMN binned_ms INTEGER",
        "CREATE TABLE trial_tag (trial_id INTEGER NOT NULL REFERENCES trial(id), tag TEXT NOT NULL, "
        "PRIMARY KEY (trial_id, tag))",
        "CREATE INDEX trial_tag_by_tag ON trial_tag(tag)",
        "ALTER TABLE team ADD COLUMN pseudonym TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE class ADD COLUMN archived_ms INTEGER",
        "CREATE TABLE scoring (task_id INTEGER NOT NULL REFERENCES task(id), position INTEGER NOT NULL, "
        "metric TEXT NOT NULL, full_at REAL NOT NULL, none_at REAL NOT NULL, points REAL NOT NULL, "
        "PRIMARY KEY (task_id, position))",
        "CREATE TABLE change_entry (id INTEGER PRIMARY KEY, made_ms INTEGER NOT NULL, kind TEXT NOT NULL, "
        "words TEXT NOT NULL)",
        "CREATE TRIGGER change_entry_kept_on_update BEFORE UPDATE ON change_entry "
        "BEGIN SELECT RAISE(ABORT, 'the list of changes is never changed'); END",
        "CREATE TRIGGER change_entry_kept_on_delete BEFORE DELETE ON change_entry "
        "BEGIN SELECT RAISE(ABORT, 'the list of changes is never deleted'); END",
        "DROP TRIGGER observation_series_kept_on_delete",
        "DROP TRIGGER observation_chunk_kept_on_delete",
        "DROP TRIGGER raw_time_chunk_kept_on_delete",
        "CREATE TRIGGER observation_series_kept_on_delete BEFORE DELETE ON observation_series "
        "WHEN (SELECT trial.state FROM recording JOIN trial ON trial.id=recording.trial_id "
        "WHERE recording.id=OLD.recording_id)<>'removed' "
        "BEGIN SELECT RAISE(ABORT, 'observations are never deleted'); END",
        "CREATE TRIGGER observation_chunk_kept_on_delete BEFORE DELETE ON observation_chunk "
        "WHEN (SELECT trial.state FROM observation_series JOIN recording ON "
        "recording.id=observation_series.recording_id "
        "JOIN trial ON trial.id=recording.trial_id WHERE observation_series.id=OLD.series_id)<>'removed' "
        "BEGIN SELECT RAISE(ABORT, 'observations are never deleted'); END",
        "CREATE TRIGGER raw_time_chunk_kept_on_delete BEFORE DELETE ON raw_time_chunk "
        "WHEN (SELECT trial.state FROM recording JOIN trial ON trial.id=recording.trial_id "
        "WHERE recording.id=OLD.recording_id) NOT IN ('recording', 'removed') "
        "BEGIN SELECT RAISE(ABORT, 'raw times are never deleted'); END",
    };
}

/// What teams and courses lacked: members and robots of teams, zones and the archive of tasks, how a robot is
/// drawn; and tracks that another program measured, as raw measurements.
std::vector<std::string> teamsAndZones()
{
    return {
        "CREATE TABLE team_member (team_id INTEGER NOT NULL REFERENCES team(id), position INTEGER NOT NULL, "
        "name TEXT NOT NULL, "
        "PRIMARY KEY (team_id, position))",
        "CREATE TABLE team_robot (team_id INTEGER NOT NULL REFERENCES team(id), position INTEGER NOT NULL, "
        "robot_id INTEGER NOT NULL REFERENCES robot(id), PRIMARY KEY (team_id, position), UNIQUE (team_id, "
        "robot_id))",
        "ALTER TABLE robot ADD COLUMN drawing_colour TEXT NOT NULL DEFAULT 'automatic'",
        "ALTER TABLE task ADD COLUMN archived_ms INTEGER",
        "CREATE TABLE zone (task_id INTEGER NOT NULL REFERENCES task(id), position INTEGER NOT NULL, name "
        "TEXT NOT NULL, "
        "rule TEXT NOT NULL, corners BLOB NOT NULL, PRIMARY KEY (task_id, position), UNIQUE (task_id, name))",
        "CREATE TABLE imported_track (id INTEGER PRIMARY KEY, trial_id INTEGER NOT NULL REFERENCES "
        "trial(id), "
        "robot_id INTEGER NOT NULL REFERENCES robot(id), imported_ms INTEGER NOT NULL, file TEXT NOT NULL, "
        "sha256 TEXT NOT NULL, "
        "bytes INTEGER NOT NULL, format TEXT NOT NULL, reading TEXT NOT NULL, samples BLOB NOT NULL)",
        "CREATE INDEX imported_track_by_trial ON imported_track(trial_id, robot_id)",
        "CREATE TRIGGER imported_track_kept_on_update BEFORE UPDATE ON imported_track "
        "BEGIN SELECT RAISE(ABORT, 'imported tracks are never changed'); END",
        "CREATE TRIGGER imported_track_kept_on_delete BEFORE DELETE ON imported_track "
        "WHEN (SELECT trial.state FROM trial WHERE trial.id=OLD.trial_id)<>'removed' "
        "BEGIN SELECT RAISE(ABORT, 'imported tracks are never deleted'); END",
    };
}

/// Analyses whose results can be proved, and series of any length: samples, points and imported tracks lie in
/// chunks as observations do. Analyses that are older have no digests: what they were made from is not known
/// any more.
std::vector<std::string> provedAnalyses()
{
    return {
        "CREATE TABLE analysis_digest (analysis_id INTEGER NOT NULL REFERENCES analysis(id), part TEXT NOT "
        "NULL, "
        "sha256 TEXT NOT NULL, PRIMARY KEY (analysis_id, part))",
        "CREATE TABLE analysis_chunk (analysis_id INTEGER NOT NULL REFERENCES analysis(id), position INTEGER "
        "NOT NULL, "
        "samples BLOB NOT NULL, points BLOB NOT NULL, PRIMARY KEY (analysis_id, position))",
        "INSERT INTO analysis_chunk SELECT analysis_id, 0, samples, points FROM analysis_series",
        "DROP TABLE analysis_series",
        "CREATE TABLE imported_track_chunk (track_id INTEGER NOT NULL REFERENCES imported_track(id), "
        "position INTEGER NOT NULL, samples BLOB NOT NULL, PRIMARY KEY (track_id, position))",
        "INSERT INTO imported_track_chunk SELECT id, 0, samples FROM imported_track",
        "ALTER TABLE imported_track DROP COLUMN samples",
        "CREATE TRIGGER imported_track_chunk_kept_on_update BEFORE UPDATE ON imported_track_chunk "
        "BEGIN SELECT RAISE(ABORT, 'imported tracks are never changed'); END",
        "CREATE TRIGGER imported_track_chunk_kept_on_delete BEFORE DELETE ON imported_track_chunk "
        "WHEN (SELECT trial.state FROM imported_track JOIN trial ON trial.id=imported_track.trial_id "
        "WHERE imported_track.id=OLD.track_id)<>'removed' "
        "BEGIN SELECT RAISE(ABORT, 'imported tracks are never deleted'); END",
    };
}

/// The point of a robot that is measured. Robots without a colour came with it, which older programs do not
/// read.
std::vector<std::string> referencePoints()
{
    return {
        "ALTER TABLE robot ADD COLUMN reference_forward_m REAL NOT NULL DEFAULT 0",
        "ALTER TABLE robot ADD COLUMN reference_left_m REAL NOT NULL DEFAULT 0",
    };
}

/// When robots of one look could not be told apart. Of older analyses it is not known.
std::vector<std::string> doubtfulNames()
{
    return {
        "CREATE TABLE doubtful_name (analysis_id INTEGER NOT NULL REFERENCES analysis(id), position INTEGER "
        "NOT NULL, "
        "from_ns INTEGER NOT NULL, to_ns INTEGER NOT NULL, PRIMARY KEY (analysis_id, position))",
        "CREATE TABLE doubtful_name_robot (analysis_id INTEGER NOT NULL REFERENCES analysis(id), position "
        "INTEGER NOT NULL, "
        "robot_id INTEGER NOT NULL REFERENCES robot(id), PRIMARY KEY (analysis_id, position, robot_id))",
    };
}

std::vector<std::string> pointedOutRobots()
{
    return {
        "CREATE TABLE pointed_out_robot (recording_id INTEGER NOT NULL REFERENCES recording(id), robot_id "
        "INTEGER NOT NULL REFERENCES robot(id), "
        "frame INTEGER NOT NULL, x_px REAL NOT NULL, y_px REAL NOT NULL, PRIMARY KEY (recording_id, "
        "robot_id))",
    };
}

} // namespace

std::vector<Migration> projectMigrations()
{
    return {
        sqlMigration(ODO_TEXT("project.format_1", "the first schema"), firstSchema()),
        sqlMigration(ODO_TEXT("project.format_2", "samples overruled by hand"), overrules()),
        sqlMigration(ODO_TEXT("project.format_3", "rates of the cameras' clocks"), clockRates()),
        sqlMigration(ODO_TEXT("project.format_4", "tasks with gates, a reference path and limits"), tasks()),
        sqlMigration(ODO_TEXT("project.format_5", "how each view was put in step"), viewsInStep()),
        sqlMigration(ODO_TEXT("project.format_6", "calibrations with their boards, corners and pictures"),
                     calibrationPictures()),
        sqlMigration(ODO_TEXT("project.format_7", "revisions that are chosen, and checks of registrations"),
                     chosenRevisions()),
        sqlMigration(ODO_TEXT("project.format_8",
                              "trials while they are being recorded, and the raw times of "
                              "their pictures"),
                     recordingsAsTheyAreMade()),
        sqlMigration(ODO_TEXT("project.format_9", "pictures of registrations"), registrationPictures()),
        sqlMigration(ODO_TEXT("project.format_10", "what a school year needs: stars, tags, archive, bin, "
                                                   "pseudonyms, scoring and the list of changes"),
                     schoolYear()),
        sqlMigration(ODO_TEXT("project.format_11", "members and robots of teams, zones and the archive of "
                                                   "tasks, and imported tracks"),
                     teamsAndZones()),
        sqlMigration(ODO_TEXT("project.format_12", "digests of analyses, and long series in chunks"),
                     provedAnalyses()),
        sqlMigration(ODO_TEXT("project.format_13", "the point of a robot that is measured"),
                     referencePoints()),
        sqlMigration(ODO_TEXT("project.format_14", "when robots of one look could not be told apart"),
                     doubtfulNames()),
        sqlMigration(ODO_TEXT("project.format_15", "robots that a person pointed out in a picture"),
                     pointedOutRobots()),
        {ODO_TEXT("project.format_16", "sentences as codes with their arguments"), storeMessages},
    };
}

const Migrator &projectMigrator()
{
    static const Migrator migrator(projectMigrations());
    return migrator;
}

} // namespace odo
