-- A task was only a name. Now it has gates, a path and limits, and an analysis refers to its task.

ALTER TABLE task ADD COLUMN template TEXT NOT NULL DEFAULT 'free';
ALTER TABLE task ADD COLUMN path_points BLOB;
ALTER TABLE task ADD COLUMN path_closed INTEGER NOT NULL DEFAULT 0;
ALTER TABLE task ADD COLUMN max_speed_m_s REAL;
ALTER TABLE task ADD COLUMN max_accel_m_s2 REAL;

CREATE TABLE gate (task_id INTEGER NOT NULL REFERENCES task(id), position INTEGER NOT NULL,
    name TEXT NOT NULL, role TEXT NOT NULL, from_x_m REAL NOT NULL, from_y_m REAL NOT NULL,
    to_x_m REAL NOT NULL, to_y_m REAL NOT NULL, PRIMARY KEY (task_id, position), UNIQUE (task_id, name));

ALTER TABLE analysis ADD COLUMN task_id INTEGER REFERENCES task(id);

CREATE TABLE gate_passage (analysis_id INTEGER NOT NULL REFERENCES analysis(id),
    position INTEGER NOT NULL, gate TEXT NOT NULL, role TEXT NOT NULL, time_ns INTEGER NOT NULL,
    sigma_s REAL NOT NULL, common_sigma_s REAL NOT NULL, PRIMARY KEY (analysis_id, position));
