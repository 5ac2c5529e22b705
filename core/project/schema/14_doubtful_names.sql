-- Periods in which robots of the same look could not be told apart; unknown for older analyses.

CREATE TABLE doubtful_name (analysis_id INTEGER NOT NULL REFERENCES analysis(id),
    position INTEGER NOT NULL, from_ns INTEGER NOT NULL, to_ns INTEGER NOT NULL,
    PRIMARY KEY (analysis_id, position));

CREATE TABLE doubtful_name_robot (analysis_id INTEGER NOT NULL REFERENCES analysis(id),
    position INTEGER NOT NULL, robot_id INTEGER NOT NULL REFERENCES robot(id),
    PRIMARY KEY (analysis_id, position, robot_id));
