-- Members and robots of teams, zones and the archive of tasks, colours in drawings, and tracks that another
-- program measured, as raw measurements.

CREATE TABLE team_member (team_id INTEGER NOT NULL REFERENCES team(id), position INTEGER NOT NULL,
    name TEXT NOT NULL, PRIMARY KEY (team_id, position));

CREATE TABLE team_robot (team_id INTEGER NOT NULL REFERENCES team(id), position INTEGER NOT NULL,
    robot_id INTEGER NOT NULL REFERENCES robot(id), PRIMARY KEY (team_id, position),
    UNIQUE (team_id, robot_id));

ALTER TABLE robot ADD COLUMN drawing_colour TEXT NOT NULL DEFAULT 'automatic';
ALTER TABLE task ADD COLUMN archived_ms INTEGER;

CREATE TABLE zone (task_id INTEGER NOT NULL REFERENCES task(id), position INTEGER NOT NULL,
    name TEXT NOT NULL, rule TEXT NOT NULL, corners BLOB NOT NULL, PRIMARY KEY (task_id, position),
    UNIQUE (task_id, name));

CREATE TABLE imported_track (id INTEGER PRIMARY KEY, trial_id INTEGER NOT NULL REFERENCES trial(id),
    robot_id INTEGER NOT NULL REFERENCES robot(id), imported_ms INTEGER NOT NULL, file TEXT NOT NULL,
    sha256 TEXT NOT NULL, bytes INTEGER NOT NULL, format TEXT NOT NULL, reading TEXT NOT NULL,
    samples BLOB NOT NULL);
CREATE INDEX imported_track_by_trial ON imported_track(trial_id, robot_id);

CREATE TRIGGER imported_track_kept_on_update BEFORE UPDATE ON imported_track
    BEGIN SELECT RAISE(ABORT, 'imported tracks are never changed'); END;

CREATE TRIGGER imported_track_kept_on_delete BEFORE DELETE ON imported_track
    WHEN (SELECT trial.state FROM trial WHERE trial.id=OLD.trial_id)<>'removed'
    BEGIN SELECT RAISE(ABORT, 'imported tracks are never deleted'); END;
