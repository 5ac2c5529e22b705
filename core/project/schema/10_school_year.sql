-- For a school year: trials are starred, tagged, archived and binned, teams have pseudonyms, tasks are scored,
-- and every change is listed. What is in the bin can be removed for good, raw measurements included: the data of
-- pupils belong to them.

ALTER TABLE trial ADD COLUMN starred INTEGER NOT NULL DEFAULT 0;
ALTER TABLE trial ADD COLUMN archived_ms INTEGER;
ALTER TABLE trial ADD COLUMN binned_ms INTEGER;

CREATE TABLE trial_tag (trial_id INTEGER NOT NULL REFERENCES trial(id), tag TEXT NOT NULL,
    PRIMARY KEY (trial_id, tag));
CREATE INDEX trial_tag_by_tag ON trial_tag(tag);

ALTER TABLE team ADD COLUMN pseudonym TEXT NOT NULL DEFAULT '';
ALTER TABLE class ADD COLUMN archived_ms INTEGER;

CREATE TABLE scoring (task_id INTEGER NOT NULL REFERENCES task(id), position INTEGER NOT NULL,
    metric TEXT NOT NULL, full_at REAL NOT NULL, none_at REAL NOT NULL, points REAL NOT NULL,
    PRIMARY KEY (task_id, position));

CREATE TABLE change_entry (id INTEGER PRIMARY KEY, made_ms INTEGER NOT NULL, kind TEXT NOT NULL,
    words TEXT NOT NULL);

CREATE TRIGGER change_entry_kept_on_update BEFORE UPDATE ON change_entry
    BEGIN SELECT RAISE(ABORT, 'the list of changes is never changed'); END;

CREATE TRIGGER change_entry_kept_on_delete BEFORE DELETE ON change_entry
    BEGIN SELECT RAISE(ABORT, 'the list of changes is never deleted'); END;

DROP TRIGGER observation_series_kept_on_delete;
DROP TRIGGER observation_chunk_kept_on_delete;
DROP TRIGGER raw_time_chunk_kept_on_delete;

CREATE TRIGGER observation_series_kept_on_delete BEFORE DELETE ON observation_series
    WHEN (SELECT trial.state FROM recording JOIN trial ON trial.id=recording.trial_id
    WHERE recording.id=OLD.recording_id)<>'removed'
    BEGIN SELECT RAISE(ABORT, 'observations are never deleted'); END;

CREATE TRIGGER observation_chunk_kept_on_delete BEFORE DELETE ON observation_chunk
    WHEN (SELECT trial.state FROM observation_series
    JOIN recording ON recording.id=observation_series.recording_id
    JOIN trial ON trial.id=recording.trial_id WHERE observation_series.id=OLD.series_id)<>'removed'
    BEGIN SELECT RAISE(ABORT, 'observations are never deleted'); END;

CREATE TRIGGER raw_time_chunk_kept_on_delete BEFORE DELETE ON raw_time_chunk
    WHEN (SELECT trial.state FROM recording JOIN trial ON trial.id=recording.trial_id
    WHERE recording.id=OLD.recording_id) NOT IN ('recording', 'removed')
    BEGIN SELECT RAISE(ABORT, 'raw times are never deleted'); END;
