-- What a person notes of a trial under a name of their own: the surface, the battery, which attempt it was. A value is
-- text; what reads as a number is shown and exported as one.

CREATE TABLE trial_variable (trial_id INTEGER NOT NULL REFERENCES trial(id), name TEXT NOT NULL,
    value TEXT NOT NULL, PRIMARY KEY (trial_id, name));
