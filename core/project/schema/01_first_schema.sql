-- Cameras, layouts, robots, teams, trials with their recordings, observations, analyses, and known truth.
-- Units and meanings are those of core/project/records.h; docs/project_file.md describes tables and blobs.

CREATE TABLE property (name TEXT PRIMARY KEY, value TEXT NOT NULL);
CREATE TABLE camera (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, device_uri TEXT NOT NULL);

CREATE TABLE lens (id INTEGER PRIMARY KEY, width_px INTEGER NOT NULL, height_px INTEGER NOT NULL,
    fx_px REAL NOT NULL, fy_px REAL NOT NULL, cx_px REAL NOT NULL, cy_px REAL NOT NULL,
    model TEXT NOT NULL, distortion BLOB NOT NULL, covariance BLOB NOT NULL);

CREATE TABLE intrinsics (id INTEGER PRIMARY KEY, camera_id INTEGER NOT NULL REFERENCES camera(id),
    lens_id INTEGER NOT NULL REFERENCES lens(id), made_ms INTEGER NOT NULL, origin TEXT NOT NULL,
    rms_px REAL NOT NULL, cross_validation_px REAL NOT NULL, verdict TEXT NOT NULL);
CREATE INDEX intrinsics_by_camera ON intrinsics(camera_id);

CREATE TABLE calibration_picture (intrinsics_id INTEGER NOT NULL REFERENCES intrinsics(id),
    position INTEGER NOT NULL, file TEXT NOT NULL, rms_px REAL NOT NULL,
    PRIMARY KEY (intrinsics_id, position));

CREATE TABLE rejected_picture (intrinsics_id INTEGER NOT NULL REFERENCES intrinsics(id),
    position INTEGER NOT NULL, file TEXT NOT NULL, reason TEXT NOT NULL,
    PRIMARY KEY (intrinsics_id, position));

CREATE TABLE layout (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE);

CREATE TABLE marker (layout_id INTEGER NOT NULL REFERENCES layout(id), position INTEGER NOT NULL,
    label TEXT NOT NULL, x_m REAL NOT NULL, y_m REAL NOT NULL, PRIMARY KEY (layout_id, position),
    UNIQUE (layout_id, label));

CREATE TABLE registration (id INTEGER PRIMARY KEY, camera_id INTEGER NOT NULL REFERENCES camera(id),
    layout_id INTEGER NOT NULL REFERENCES layout(id), intrinsics_id INTEGER REFERENCES intrinsics(id),
    assumed_lens_id INTEGER NOT NULL REFERENCES lens(id), made_ms INTEGER NOT NULL, qw REAL NOT NULL,
    qx REAL NOT NULL, qy REAL NOT NULL, qz REAL NOT NULL, x_m REAL NOT NULL, y_m REAL NOT NULL,
    z_m REAL NOT NULL, pose_covariance BLOB NOT NULL, rms_px REAL NOT NULL, rms_m REAL NOT NULL,
    verdict TEXT NOT NULL);
CREATE INDEX registration_by_camera ON registration(camera_id);

CREATE TABLE registration_pixel (registration_id INTEGER NOT NULL REFERENCES registration(id),
    position INTEGER NOT NULL, label TEXT NOT NULL, u_px REAL NOT NULL, v_px REAL NOT NULL,
    PRIMARY KEY (registration_id, position));

CREATE TABLE registration_error (registration_id INTEGER NOT NULL REFERENCES registration(id),
    position INTEGER NOT NULL, label TEXT NOT NULL, error_m REAL NOT NULL, error_px REAL NOT NULL,
    PRIMARY KEY (registration_id, position));

CREATE TABLE robot (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, colour TEXT NOT NULL,
    height_mode TEXT NOT NULL, height_m REAL, length_m REAL, width_m REAL);

CREATE TABLE class (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE);

CREATE TABLE team (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE,
    class_id INTEGER REFERENCES class(id));

CREATE TABLE task (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE);

CREATE TABLE trial (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE,
    team_id INTEGER REFERENCES team(id), task_id INTEGER REFERENCES task(id), date_ms INTEGER NOT NULL,
    notes TEXT NOT NULL, sync_method TEXT NOT NULL, sync_offset_s REAL NOT NULL,
    sync_offset_sigma_s REAL NOT NULL, sync_score REAL NOT NULL, duration_s REAL NOT NULL);
CREATE INDEX trial_by_date ON trial(date_ms);

CREATE TABLE trial_robot (trial_id INTEGER NOT NULL REFERENCES trial(id), position INTEGER NOT NULL,
    robot_id INTEGER NOT NULL REFERENCES robot(id), PRIMARY KEY (trial_id, position),
    UNIQUE (trial_id, robot_id));

CREATE TABLE recording (id INTEGER PRIMARY KEY, trial_id INTEGER NOT NULL REFERENCES trial(id),
    camera_id INTEGER NOT NULL REFERENCES camera(id), position INTEGER NOT NULL, path TEXT NOT NULL,
    sha256 TEXT NOT NULL, bytes INTEGER NOT NULL, width_px INTEGER NOT NULL, height_px INTEGER NOT NULL,
    frames_per_second REAL NOT NULL, start_offset_s REAL NOT NULL, UNIQUE (trial_id, position));

CREATE TABLE frame_time_chunk (recording_id INTEGER NOT NULL REFERENCES recording(id),
    position INTEGER NOT NULL, times BLOB NOT NULL, PRIMARY KEY (recording_id, position));

CREATE TABLE observation_series (id INTEGER PRIMARY KEY,
    recording_id INTEGER NOT NULL REFERENCES recording(id),
    robot_id INTEGER NOT NULL REFERENCES robot(id), algorithm TEXT NOT NULL);
CREATE INDEX observation_series_by_recording ON observation_series(recording_id, robot_id);

CREATE TABLE observation_chunk (series_id INTEGER NOT NULL REFERENCES observation_series(id),
    position INTEGER NOT NULL, observations BLOB NOT NULL, PRIMARY KEY (series_id, position));

CREATE TRIGGER observation_series_kept_on_update BEFORE UPDATE ON observation_series
    BEGIN SELECT RAISE(ABORT, 'observations are never changed'); END;

CREATE TRIGGER observation_series_kept_on_delete BEFORE DELETE ON observation_series
    BEGIN SELECT RAISE(ABORT, 'observations are never deleted'); END;

CREATE TRIGGER observation_chunk_kept_on_update BEFORE UPDATE ON observation_chunk
    BEGIN SELECT RAISE(ABORT, 'observations are never changed'); END;

CREATE TRIGGER observation_chunk_kept_on_delete BEFORE DELETE ON observation_chunk
    BEGIN SELECT RAISE(ABORT, 'observations are never deleted'); END;

CREATE TABLE analysis (id INTEGER PRIMARY KEY, trial_id INTEGER NOT NULL REFERENCES trial(id),
    robot_id INTEGER NOT NULL REFERENCES robot(id), made_ms INTEGER NOT NULL,
    software_version TEXT NOT NULL, smoother TEXT NOT NULL, max_speed_m_s REAL NOT NULL,
    max_accel_m_s2 REAL NOT NULL, longest_bridged_gap_ns INTEGER NOT NULL, height_m REAL NOT NULL,
    height_estimated INTEGER NOT NULL, mean_view_disagreement_m REAL NOT NULL);
CREATE INDEX analysis_by_trial ON analysis(trial_id, robot_id);

CREATE TABLE analysis_series (analysis_id INTEGER PRIMARY KEY REFERENCES analysis(id),
    samples BLOB NOT NULL, points BLOB NOT NULL);

CREATE TABLE analysis_view (analysis_id INTEGER NOT NULL REFERENCES analysis(id),
    position INTEGER NOT NULL, name TEXT NOT NULL, registration_id INTEGER REFERENCES registration(id),
    PRIMARY KEY (analysis_id, position));

CREATE TABLE metric (analysis_id INTEGER NOT NULL REFERENCES analysis(id), position INTEGER NOT NULL,
    name TEXT NOT NULL, unit TEXT NOT NULL, value REAL NOT NULL, sigma REAL,
    PRIMARY KEY (analysis_id, position));

CREATE TABLE spike (analysis_id INTEGER NOT NULL REFERENCES analysis(id), position INTEGER NOT NULL,
    sample_index INTEGER NOT NULL, time_ns INTEGER NOT NULL, flags INTEGER NOT NULL,
    reason TEXT NOT NULL, PRIMARY KEY (analysis_id, position));

CREATE TABLE truth (trial_id INTEGER NOT NULL REFERENCES trial(id),
    robot_id INTEGER NOT NULL REFERENCES robot(id), series BLOB NOT NULL,
    PRIMARY KEY (trial_id, robot_id));
