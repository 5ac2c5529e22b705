-- Manual overrides of single samples: those in force for each trial and robot, and those of each analysis.

CREATE TABLE overrule (trial_id INTEGER NOT NULL REFERENCES trial(id),
    robot_id INTEGER NOT NULL REFERENCES robot(id), frame INTEGER NOT NULL, is_spike INTEGER NOT NULL,
    PRIMARY KEY (trial_id, robot_id, frame));

CREATE TABLE analysis_overrule (analysis_id INTEGER NOT NULL REFERENCES analysis(id),
    frame INTEGER NOT NULL, is_spike INTEGER NOT NULL, PRIMARY KEY (analysis_id, frame));
