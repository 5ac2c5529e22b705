-- Reference points of robots. Robots without a colour came with it, and older programs cannot read them.

ALTER TABLE robot ADD COLUMN reference_forward_m REAL NOT NULL DEFAULT 0;
ALTER TABLE robot ADD COLUMN reference_left_m REAL NOT NULL DEFAULT 0;
