-- Digests prove the results of analyses. Samples, points and imported tracks of any length are in chunks, as
-- observations are. Older analyses have no digests, because their sources are unknown.

CREATE TABLE analysis_digest (analysis_id INTEGER NOT NULL REFERENCES analysis(id), part TEXT NOT NULL,
    sha256 TEXT NOT NULL, PRIMARY KEY (analysis_id, part));

CREATE TABLE analysis_chunk (analysis_id INTEGER NOT NULL REFERENCES analysis(id),
    position INTEGER NOT NULL, samples BLOB NOT NULL, points BLOB NOT NULL,
    PRIMARY KEY (analysis_id, position));

INSERT INTO analysis_chunk SELECT analysis_id, 0, samples, points FROM analysis_series;

DROP TABLE analysis_series;

CREATE TABLE imported_track_chunk (track_id INTEGER NOT NULL REFERENCES imported_track(id),
    position INTEGER NOT NULL, samples BLOB NOT NULL, PRIMARY KEY (track_id, position));

INSERT INTO imported_track_chunk SELECT id, 0, samples FROM imported_track;

ALTER TABLE imported_track DROP COLUMN samples;

CREATE TRIGGER imported_track_chunk_kept_on_update BEFORE UPDATE ON imported_track_chunk
    BEGIN SELECT RAISE(ABORT, 'imported tracks are never changed'); END;

CREATE TRIGGER imported_track_chunk_kept_on_delete BEFORE DELETE ON imported_track_chunk
    WHEN (SELECT trial.state FROM imported_track JOIN trial ON trial.id=imported_track.trial_id
    WHERE imported_track.id=OLD.track_id)<>'removed'
    BEGIN SELECT RAISE(ABORT, 'imported tracks are never deleted'); END;
