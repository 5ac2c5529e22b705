-- The range of a trial's time that its results are of; NULL: all of it. An analysis has the range that it was
-- measured by.

ALTER TABLE trial ADD COLUMN range_from_ns INTEGER;
ALTER TABLE trial ADD COLUMN range_to_ns INTEGER;

ALTER TABLE analysis ADD COLUMN range_from_ns INTEGER;
ALTER TABLE analysis ADD COLUMN range_to_ns INTEGER;

-- What a person notes of a trial under a name of their own: the surface, the battery, which attempt it was. A value is
-- text; what reads as a number is shown and exported as one.

CREATE TABLE trial_variable (trial_id INTEGER NOT NULL REFERENCES trial(id), name TEXT NOT NULL,
    value TEXT NOT NULL, PRIMARY KEY (trial_id, name));
