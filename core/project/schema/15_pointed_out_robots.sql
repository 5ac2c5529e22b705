-- Robots that a person marked in a frame.

CREATE TABLE pointed_out_robot (recording_id INTEGER NOT NULL REFERENCES recording(id),
    robot_id INTEGER NOT NULL REFERENCES robot(id), frame INTEGER NOT NULL, x_px REAL NOT NULL,
    y_px REAL NOT NULL, PRIMARY KEY (recording_id, robot_id));
