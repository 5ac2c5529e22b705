-- A trial is in the project while it is being recorded, with the raw times of its frames.

ALTER TABLE trial ADD COLUMN state TEXT NOT NULL DEFAULT 'complete';

CREATE TABLE raw_time_chunk (recording_id INTEGER NOT NULL REFERENCES recording(id),
    position INTEGER NOT NULL, pictures BLOB NOT NULL, readings BLOB NOT NULL,
    PRIMARY KEY (recording_id, position));

CREATE TRIGGER raw_time_chunk_kept_on_update BEFORE UPDATE ON raw_time_chunk
    BEGIN SELECT RAISE(ABORT, 'raw times are never changed'); END;

CREATE TRIGGER raw_time_chunk_kept_on_delete BEFORE DELETE ON raw_time_chunk
    WHEN (SELECT trial.state FROM recording JOIN trial ON trial.id=recording.trial_id
    WHERE recording.id=OLD.recording_id)<>'recording'
    BEGIN SELECT RAISE(ABORT, 'raw times are never deleted'); END;
