-- The revision in force can be chosen, and checks whether a camera has moved are kept.

ALTER TABLE camera ADD COLUMN intrinsics_id INTEGER REFERENCES intrinsics(id);
ALTER TABLE camera ADD COLUMN registration_id INTEGER REFERENCES registration(id);
ALTER TABLE registration ADD COLUMN software_version TEXT NOT NULL DEFAULT '';

CREATE TABLE registration_check (id INTEGER PRIMARY KEY,
    registration_id INTEGER NOT NULL REFERENCES registration(id), made_ms INTEGER NOT NULL,
    outcome TEXT NOT NULL, shift_px REAL NOT NULL, shift_m REAL NOT NULL, words TEXT NOT NULL);
CREATE INDEX registration_check_by_registration ON registration_check(registration_id);
