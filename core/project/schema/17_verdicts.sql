-- What the checks of a trial's results said, and the doubtful verdicts that a person accepts with a reason. A
-- stored verdict counts as long as its basis is what it follows from; trials of older versions have none until
-- it is computed. Metrics that are at least so large; unknown (NULL) for older analyses.

CREATE TABLE verdict (trial_id INTEGER PRIMARY KEY REFERENCES trial(id), basis TEXT NOT NULL);

CREATE TABLE verdict_check (trial_id INTEGER NOT NULL REFERENCES trial(id), position INTEGER NOT NULL,
    code TEXT NOT NULL, level TEXT NOT NULL, words TEXT NOT NULL, PRIMARY KEY (trial_id, position));

CREATE TABLE accepted_verdict (trial_id INTEGER PRIMARY KEY REFERENCES trial(id), accepted_ms INTEGER NOT NULL,
    reason TEXT NOT NULL);

CREATE TABLE accepted_check (trial_id INTEGER NOT NULL REFERENCES trial(id), code TEXT NOT NULL,
    PRIMARY KEY (trial_id, code));

ALTER TABLE metric ADD COLUMN at_least INTEGER;
